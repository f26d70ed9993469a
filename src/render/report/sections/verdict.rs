//! The verdict at the top of the page, and what is used most.

use crate::answer::certify::{Figure, Quantity};
use crate::render::figures::{DASH, DIGITS, NOT_RESOLVED, with_error};
use crate::render::report::Inputs;
use crate::render::report::html::list;
use crate::render::summary::Summary;
use crate::render::table::html::table;
use crate::render::table::{Cell, Number, Table};
use crate::render::terminal::how_it_ended;
use crate::render::text::significant;
use crate::render::utilisation::{Utilisation, largest, utilisations};
use crate::render::verdict::{self, News, Verdict, missed_rules, open_rule};
use maud::{Markup, html};

pub fn verdict(inputs: &Inputs) -> Markup {
    let all = utilisations(inputs.summary);
    let Verdict { news, head, rest } = verdict::verdict(inputs.summary, inputs.missed);
    let warnings: Vec<String> = (inputs.summary.warnings.iter())
        .map(|w| w.0.clone())
        .collect();
    html! {
        p class=(format!("verdict {}", class(news))) role="status" {
            b { (head) } " " (rest.join(" "))
        }
        (cards(inputs, largest(&all)))
        (list("Not resolved by this mesh", &unsure(inputs.summary)))
        (list("Warnings", &warnings))
        @if !all.is_empty() {
            h3 { "Utilisation" }
            (table(&used(&all, &inputs.summary.units.stress)))
        }
    }
}

/// The figures of which no error is known, with the reason where there is one.
fn unsure(summary: &Summary) -> Vec<String> {
    let said = |claim: &Figure| {
        let why = claim
            .note
            .map_or_else(String::new, |note| format!(": {note}"));
        format!("{} of {}{why}", claim.what.name(), claim.place)
    };
    summary.answer.unresolved().into_iter().map(said).collect()
}

fn class(news: News) -> &'static str {
    match news {
        News::Good => "good",
        News::Care => "care",
        News::Bad => "bad",
    }
}

fn card(title: &str, news: Option<News>, value: &str, below: &str) -> Markup {
    html! {
        div class="card" {
            h3 { (title) }
            div class="value" {
                @match news {
                    Some(news) => b class=(class(news)) { (value) },
                    None => (value),
                }
            }
            p { (below) }
        }
    }
}

fn cards(inputs: &Inputs, largest: Option<&Utilisation>) -> Markup {
    let summary = inputs.summary;
    let units = &summary.units;
    let solution = how_it_ended(&summary.answer);
    let news = if summary.answer.converged {
        News::Good
    } else {
        News::Bad
    };
    let checks = &summary.answer.checks;
    let balance = checks.force_balance.map_or_else(String::new, |b| {
        format!("force balance {b:.0e} of the load, ")
    });
    let penetration = checks
        .max_penetration_relative
        .map_or_else(String::new, |p| {
            format!("penetration {p:.0e} of the descent")
        });
    let (limits, limits_grade) = if inputs.missed.is_empty() {
        ("within limits".to_string(), News::Good)
    } else {
        (format!("{} missed", inputs.missed.len()), News::Bad)
    };
    let descent = summary.answer.descent.map_or_else(
        || DASH.to_string(),
        |value| {
            let error = summary.answer.figure(Quantity::Descent, "overall");
            if error.is_some_and(|c| !c.is_resolved()) {
                NOT_RESOLVED.to_string()
            } else {
                format!(
                    "{} {}",
                    with_error(value, error.and_then(Figure::bar)),
                    units.length
                )
            }
        },
    );
    html! {
        div class="cards" {
            (card("Solution", Some(news), solution,
                &format!("{} iterations, {} unknowns", summary.counters.iterations, summary.counters.dofs)))
            (card("Checks", Some(limits_grade), &limits, &format!("{balance}{penetration}")))
            @if summary.sizing.as_ref().is_some_and(|s| !s.lines.is_empty()) { (sizing_card(summary)) }
            @if let Some(most) = largest {
                (card(
                    "Largest utilisation",
                    Some(if most.share() > 1.0 || !most.resolved { News::Care } else { News::Good }),
                    &share_of(most),
                    &format!("{}, {}, of {}", most.what, most.place, most.against),
                ))
            }
            (card("Descent", None, &descent,
                &format!("under {} {}{}", significant(summary.answer.applied_load, 4), units.force, at_end_of(summary))))
        }
    }
}

/// Of which step, where there are several.
fn at_end_of(summary: &Summary) -> String {
    if summary.answer.steps.len() > 1 {
        format!(", step “{}”", summary.answer.step)
    } else {
        String::new()
    }
}

fn sizing_card(summary: &Summary) -> Markup {
    let judged = (summary.sizing.iter())
        .any(|s| s.rule.is_some() || s.lines.iter().any(|l| l.met.is_some()));
    let missed = missed_rules(summary);
    let rules = match summary.sizing.as_ref().is_some_and(|s| s.rule.is_some()) {
        true => "rules (2-49) to (2-51)",
        false => "pressure limit (2-49)",
    };
    match (judged, missed.is_empty()) {
        (false, _) => card(
            "Sizing rules",
            None,
            "no limit",
            "no steel of this case can yield",
        ),
        (true, true) if open_rule(summary).is_some() => {
            card("Sizing rules", Some(News::Care), "open", rules)
        }
        (true, true) => card("Sizing rules", Some(News::Good), "met", rules),
        (true, false) => card("Sizing rules", Some(News::Bad), "NOT met", rules),
    }
}

/// The share that is used, in large type, where it is known.
fn share_of(most: &Utilisation) -> String {
    if !most.resolved {
        return NOT_RESOLVED.to_string();
    }
    let error = most.share_error().map(|e| 100.0 * e);
    format!("{} %", with_error(100.0 * most.share(), error))
}

fn used(all: &[Utilisation], stress: &str) -> Table {
    let mut table = Table::new("")
        .words("figure")
        .words("where")
        .figure("value", stress)
        .figure("limit", stress)
        .figures(["of the limit", "error"])
        .words("limit")
        .about(
            "Errors are the certificate's: the true value lies within them in 95 of 100 cases; a dash where there \
             is none. Mises stresses are of nodes, elastic where steel has yielded, and away from singular edges, \
             where they have no bound.",
        );
    for u in all {
        let error = u.error.filter(|_| u.value != 0.0).map(|e| e / u.value);
        let share = share_of(u);
        table.row([
            (&u.what).into(),
            (&u.place).into(),
            Cell::Figure(Number {
                error: u.error,
                resolved: u.resolved,
                ..Number::new(u.value, DIGITS)
            }),
            Cell::figure(u.limit),
            if u.share() > 1.0 || !u.resolved {
                Cell::Care(share)
            } else {
                share.into()
            },
            Cell::Share(error),
            u.against.into(),
        ]);
    }
    table
}
