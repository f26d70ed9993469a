//! The table of extreme cases, for the terminal and for the documentation.

use super::outcome::{ExtremeOutcome, ExtremeVerdict};
use crate::ground::markdown::table;

/// What came of a case, in words.
fn words(outcome: &ExtremeOutcome) -> String {
    match &outcome.verdict {
        ExtremeVerdict::Solved { error } => format!("error {error:.0e}"),
        ExtremeVerdict::Refused { message } => message.clone(),
        ExtremeVerdict::Wrong { why } => why.clone(),
        ExtremeVerdict::Unexpected { message } => message.clone(),
        ExtremeVerdict::Endless => "its iterations were used up".to_owned(),
        ExtremeVerdict::Panicked => "it panicked".to_owned(),
    }
}

fn mark(outcome: &ExtremeOutcome) -> &'static str {
    if outcome.holds() { "ok" } else { "FAILS" }
}

/// The head of the lines.
pub fn head() -> String {
    format!(
        "{:5} {:62} {:>10} {:>9} {:>7}  outcome",
        "", "case", "iterations", "cut-backs", "s"
    )
}

/// A line for the terminal.
pub fn line(outcome: &ExtremeOutcome) -> String {
    format!(
        "{:5} {:62} {:>10} {:>9} {:>7.2}  {}",
        mark(outcome),
        outcome.what,
        outcome.iterations,
        outcome.cut_backs,
        outcome.seconds,
        words(outcome)
    )
}

/// The section of `docs/stability.md`.
pub fn section(outcomes: &[ExtremeOutcome]) -> String {
    let failed = outcomes.iter().filter(|o| !o.holds()).count();
    format!(
        "Written by `brinell verify --suite extreme --write`; do not edit. Each row is a case of\n\
         [`cases/extreme`](../cases/extreme/suite.toml), run as a user's case is. It must be solved\n\
         with the value that theory gives, or be refused with a diagnosis that names the cause. The\n\
         error is relative to that value, the largest where several are checked.\n\n\
         {} cases, {failed} not as expected.\n\n{}",
        outcomes.len(),
        table(HEADINGS, outcomes.iter().map(row))
    )
}

const HEADINGS: [&str; 7] = [
    "",
    "case",
    "expected",
    "outcome",
    "iterations",
    "cut-backs",
    "s",
];

fn row(o: &ExtremeOutcome) -> [String; 7] {
    [
        mark(o).to_owned(),
        o.what.clone(),
        o.expected.clone(),
        words(o).to_owned(),
        o.iterations.to_string(),
        o.cut_backs.to_string(),
        format!("{:.2}", o.seconds),
    ]
}
