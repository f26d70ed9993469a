//! The verdict: may the answer be used, are the sizing rules met, what is used most.

use super::utilisation::{Utilisation, largest, utilisations};
use crate::answer::certify::{Figure, Quantity};
use crate::render::figures::{DASH, DIGITS, NOT_RESOLVED, share, with_error};
use crate::render::report::Inputs;
use crate::render::report::html::list;
use crate::render::summary::Summary;
use crate::render::table::html::table;
use crate::render::table::{Cell, Number, Table};
use crate::render::text::significant;
use maud::{Markup, html};

/// How good the news is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Grade {
    Good,
    Care,
    Bad,
}

impl Grade {
    fn class(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Care => "care",
            Self::Bad => "bad",
        }
    }
}

pub fn verdict(inputs: &Inputs) -> Markup {
    let all = utilisations(inputs);
    let (grade, head, rest) = said(inputs);
    let warnings: Vec<String> = (inputs.summary.warnings.iter())
        .map(|w| w.0.clone())
        .collect();
    html! {
        p class=(format!("verdict {}", grade.class())) role="status" {
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

/// How good, the first sentence and the others.
fn said(inputs: &Inputs) -> (Grade, &'static str, Vec<String>) {
    let summary = inputs.summary;
    if !summary.answer.converged {
        let done = share(Some(summary.answer.step_done));
        let why = format!(
            "The solution has not converged: what follows is the last increment that was done, {done} of \
             step “{}”.",
            summary.answer.step
        );
        return (Grade::Bad, "No answer.", vec![why]);
    }
    if !inputs.missed.is_empty() {
        let missed = inputs.missed.join("; ");
        return (
            Grade::Bad,
            "Not to be relied upon.",
            vec![format!("{missed}.")],
        );
    }
    let missed = missed_rules(summary);
    let flows =
        (summary.answer.bodies.0.iter()).max_by(|a, b| a.1.peeq_max.total_cmp(&b.1.peeq_max));
    let flows = flows.filter(|(_, body)| body.peeq_max > 0.0);
    let yields = inputs.scene.materials.iter().any(|m| !m.is_elastic());
    let mut rest = Vec::new();
    if !missed.is_empty() {
        rest.push(format!("{}.", missed.join("; ")));
    } else if summary.sizing.is_some() {
        rest.push("The sizing rules (2-49) to (2-51) are met.".to_string());
    }
    match flows {
        Some((name, body)) => rest.push(format!(
            "Plastic strain is up to {} in {name}.",
            significant(body.peeq_max, 2)
        )),
        None if yields && inputs.scene.controls.plasticity => {
            rest.push("Nothing yields.".to_string());
        }
        None => rest.push("Steel is taken as elastic.".to_string()),
    }
    rest.push("The solution has converged, and every check of it is within its limit.".to_string());
    let unsure = summary.answer.unresolved().len();
    if unsure > 0 {
        rest.push(format!(
            "This mesh does not resolve {unsure} of {} certified figures: they are named below.",
            summary.answer.certificate.len()
        ));
    }
    let (grade, head) = match (missed.is_empty(), flows) {
        (false, None) => (Grade::Bad, "Solved; the sizing rules are not met."),
        (false, Some(_)) => (
            Grade::Bad,
            "Solved; the sizing rules are not met, and steel yields.",
        ),
        (true, Some(_)) => (Grade::Care, "Solved; steel yields."),
        (true, None) if unsure > 0 => (Grade::Care, "Solved; not all figures are resolved."),
        (true, None) => (Grade::Good, "Solved."),
    };
    (grade, head, rest)
}

/// The sizing rules that are missed, in words.
fn missed_rules(summary: &Summary) -> Vec<String> {
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut missed = Vec::new();
    let lines = sizing.lines.iter().filter(|line| line.met == Some(false));
    let most = |share: &Option<f64>| share.unwrap_or(0.0);
    let worst = lines
        .clone()
        .max_by(|a, b| most(&a.utilisation).total_cmp(&most(&b.utilisation)));
    if let Some(line) = worst {
        let (count, of) = (lines.count(), sizing.lines.len());
        missed.push(format!(
            "{count} of {of} lines of contact press beyond 1.65 times yield, (2-49), most of all {} at {} of the limit",
            line.interface,
            share(line.utilisation)
        ));
    }
    if let Some(rule) = &sizing.rule {
        for (name, demand) in [("printed", rule.printed), ("exact", rule.exact)] {
            if !demand.met {
                let used = demand.required_diameter_times_length / demand.provided;
                missed.push(format!(
                    "D L is short by the {name} constant, (2-50): {} of what there is",
                    share(Some(used))
                ));
            }
        }
    }
    missed
}

fn card(title: &str, grade: Option<Grade>, value: &str, below: &str) -> Markup {
    html! {
        div class="card" {
            h3 { (title) }
            div class="value" {
                @match grade {
                    Some(grade) => b class=(grade.class()) { (value) },
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
    let (solution, grade) = if summary.answer.converged {
        ("converged", Grade::Good)
    } else {
        ("NOT CONVERGED", Grade::Bad)
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
        ("within limits".to_string(), Grade::Good)
    } else {
        (format!("{} missed", inputs.missed.len()), Grade::Bad)
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
            (card("Solution", Some(grade), solution,
                &format!("{} iterations, {} unknowns", summary.counters.iterations, summary.counters.dofs)))
            (card("Checks", Some(limits_grade), &limits, &format!("{balance}{penetration}")))
            @if summary.sizing.is_some() { (sizing_card(summary)) }
            @if let Some(most) = largest {
                (card(
                    "Largest utilisation",
                    Some(if most.share() > 1.0 || !most.resolved { Grade::Care } else { Grade::Good }),
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
    let rules = "rules (2-49) to (2-51)";
    match (judged, missed.is_empty()) {
        (false, _) => card(
            "Sizing rules",
            None,
            "no limit",
            "no steel of this case can yield",
        ),
        (true, true) => card("Sizing rules", Some(Grade::Good), "met", rules),
        (true, false) => card("Sizing rules", Some(Grade::Bad), "NOT met", rules),
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
            "Errors are the certificate's estimates of this mesh, of the right size and no bounds; a dash where there \
             is none. Mises stresses are nodal averages, elastic where steel has yielded, and away from loaded edges, \
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
