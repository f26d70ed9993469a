//! The table of extreme cases, for the terminal and for the documentation.

use super::outcome::{ExtremeOutcome, ExtremeVerdict};

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
    let mut text = format!(
        "Written by `brinell verify --suite extreme --write`; do not edit. Each row is a case of\n\
         [`cases/extreme`](../cases/extreme/suite.toml), run as a user's case is. It must be solved\n\
         with the value that theory gives, or be refused with a diagnosis that names the cause. The\n\
         error is relative to that value, the largest where several are checked.\n\n\
         {} cases, {failed} not as expected.\n\n\
         | | case | expected | outcome | iterations | cut-backs | s |\n\
         |---|---|---|---|---|---|---|\n",
        outcomes.len()
    );
    for o in outcomes {
        text.push_str(&format!(
            "| {} | {} | {} | {} | {} | {} | {:.2} |\n",
            mark(o),
            o.what,
            o.expected,
            words(o).replace('|', "\\|"),
            o.iterations,
            o.cut_backs,
            o.seconds
        ));
    }
    text
}
