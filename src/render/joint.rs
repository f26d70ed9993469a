//! One page for several runs that belong together: the combinations of a case, the positions of a bearing.

use crate::ground::file::{FileError, write_text};
use crate::render::figures::{share, with_error};
use crate::render::report::html_head;
use crate::render::sections;
use crate::render::summary::Summary;
use crate::render::table::html::{table, tables};
use crate::render::table::{Cell, Table};
use crate::render::text::significant;
use crate::render::utilisation::{Utilisation, largest, utilisations};
use crate::render::verdict::{News, Verdict, verdict};
use maud::{DOCTYPE, Markup, html};
use std::error::Error;
use std::path::Path;

/// One of the runs.
#[derive(Debug, Clone, Copy)]
pub struct JointPart<'a> {
    pub name: &'a str,
    /// What acts, such as the actions with their factors.
    pub acts: &'a str,
    /// The hash of its case file.
    pub case_hash: &'a str,
    /// Its folder, beside the page.
    pub folder: &'a str,
    /// What was found, or why there is no answer.
    pub summary: Result<&'a Summary, &'a dyn Error>,
    /// Limits of the checks that it misses, in words.
    pub missed: &'a [String],
}

impl JointPart<'_> {
    /// The verdict on it.
    pub fn verdict(&self) -> Verdict {
        match self.summary {
            Ok(summary) => verdict(summary, self.missed),
            Err(why) => Verdict {
                news: News::Bad,
                head: "No answer.".to_owned(),
                rest: vec![format!("{why}.")],
            },
        }
    }
}

/// What uses most of its limit in a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Governing {
    /// The figure, its place and what the limit is, in words.
    pub what: String,
    /// Figure over limit.
    pub utilisation: f64,
    /// What that may be off by; `None` where nothing is known.
    pub error: Option<f64>,
    pub resolved: bool,
}

/// What governs a run, as its digest has it: the largest share of a stress or a pressure in its limit. Design rules are told
/// beside it; those of loads would be squares of such shares.
pub fn governing(summary: &Summary) -> Option<Governing> {
    let used = utilisations(summary);
    largest(&used).map(|most: &Utilisation| Governing {
        what: format!("{} of {}, of {}", most.what, most.place, most.against),
        utilisation: most.share(),
        error: most.share_error(),
        resolved: most.resolved,
    })
}

/// The run that governs all, before others one without an answer: its index.
pub fn governs(parts: &[JointPart]) -> Option<usize> {
    let share = |part: &JointPart| match part.summary {
        Ok(summary) => governing(summary).map_or(f64::NEG_INFINITY, |most| most.utilisation),
        Err(_) => f64::INFINITY,
    };
    let shares: Vec<f64> = parts.iter().map(share).collect();
    let most = shares.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    shares
        .iter()
        .position(|share| *share == most && most > f64::NEG_INFINITY)
}

/// One line a run: its verdict, and what uses most.
pub fn overview(parts: &[JointPart]) -> Table {
    let mut found = parts.iter().filter_map(|part| part.summary.ok());
    let units = found.next().map(|summary| &summary.units);
    let mut table = Table::new("")
        .words("run")
        .words("acts")
        .figure("load", units.map_or("", |units| &units.force))
        .words("verdict")
        .figures(["used", "± error"])
        .words("by");
    for part in parts {
        let most = part.summary.ok().and_then(governing);
        let verdict = part.verdict();
        let head = verdict.head.clone();
        table.row([
            part.name.into(),
            part.acts.into(),
            Cell::figure(part.summary.ok().map(|summary| summary.answer.applied_load)),
            match verdict.news {
                News::Good => head.into(),
                _ => Cell::Care(head),
            },
            match &most {
                Some(most) if !most.resolved => {
                    Cell::Care(format!("{}, NOT RESOLVED", share(Some(most.utilisation))))
                }
                most => Cell::Share(most.as_ref().map(|most| most.utilisation)),
            },
            Cell::Share(most.as_ref().and_then(|most| most.error)),
            match part.summary {
                Ok(_) => most.map_or_else(|| "no limit".to_owned(), |most| most.what),
                Err(why) => why.to_string(),
            }
            .into(),
        ]);
    }
    if let Some(part) = governs(parts).and_then(|index| parts.get(index)) {
        table.note(format!("{} governs", part.name));
    }
    table
}

/// The page; `about` are sentences below its title.
pub fn page(title: &str, about: &[String], parts: &[JointPart]) -> Markup {
    let mut found = parts.iter().filter_map(|part| part.summary.ok());
    let block = found.next().map(|summary| &summary.title_block.0);
    html! {
        (DOCTYPE)
        html lang="en" {
            (html_head(title, "default-src 'none'; style-src 'unsafe-inline'"))
            body {
                h1 { (title) }
                p class="sub" { "Brinell " (env!("CARGO_PKG_VERSION")) }
                @if let Some(entries) = block.filter(|entries| !entries.is_empty()) {
                    dl class="title-block" {
                        @for (name, text) in entries { div { dt { (name) } dd { (text.as_deref().unwrap_or_default()) } } }
                    }
                }
                (head(parts))
                @for sentence in about { p { (sentence) } }
                section id="overview" { h2 { "All runs" } (table(&overview(parts))) }
                @for part in parts { section id=(part.name) { (one(part)) } }
            }
        }
    }
}

/// The verdict on all: that of the run with the worst news, and what governs.
fn head(parts: &[JointPart]) -> Markup {
    let verdicts = parts.iter().map(|part| (part, part.verdict()));
    let rank = |news: News| match news {
        News::Good => 0,
        News::Care => 1,
        News::Bad => 2,
    };
    // Of equally bad news that of the run that governs.
    let first = governs(parts).map(|index| parts[index].name);
    let order =
        |(part, verdict): &(&JointPart, Verdict)| (rank(verdict.news), Some(part.name) == first);
    let worst = verdicts.reduce(|worst, other| match order(&other) > order(&worst) {
        true => other,
        false => worst,
    });
    let Some((part, verdict)) = worst else {
        return html! {};
    };
    let class = ["good", "care", "bad"][rank(verdict.news)];
    let most = governs(parts).and_then(|index| parts.get(index));
    let most = most.and_then(|part| Some((part, governing(part.summary.ok()?)?)));
    html! {
        p class=(format!("verdict {class}")) role="status" {
            b { (part.name) ": " (verdict.head) } " " (verdict.rest.first().cloned().unwrap_or_default())
            @if let Some((part, most)) = most {
                " " (part.name) " governs: " (with_error(100.0 * most.utilisation, most.error.map(|e| 100.0 * e)))
                " % of its limit, " (most.what) "."
            }
        }
    }
}

/// What a checker wants of one run; the rest is on its own page.
fn one(part: &JointPart) -> Markup {
    let hash = html! { p class="note" { "case file, FNV-1a: " code { (part.case_hash) } } };
    let summary = match part.summary {
        Ok(summary) => summary,
        Err(why) => {
            return html! { h2 { (part.name) } p { (part.acts) ": no answer: " (why) "." } (hash) };
        }
    };
    let units = &summary.units;
    let load = significant(summary.answer.applied_load, 5);
    html! {
        h2 { (part.name) }
        p { (part.acts) ": " (load) " " (units.force) ". All of it: "
            a href=(format!("{}/report.html", part.folder)) { (part.folder) "/report.html" } }
        (hash)
        (tables(&sections::rules(summary)))
        (table(&sections::certificate(summary)))
        (table(&sections::hand_checks(summary)))
        @if !summary.warnings.is_empty() {
            h3 { "Warnings" }
            ul { @for warning in &summary.warnings { li { (warning.0) } } }
        }
    }
}

/// Writes the page, whole or not at all.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(
    title: &str,
    about: &[String],
    parts: &[JointPart],
    path: &Path,
) -> Result<(), FileError> {
    let text = page(title, about, parts).into_string();
    write_text(path, &text)
}
