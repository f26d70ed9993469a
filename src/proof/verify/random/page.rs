//! Random cases in words: a line each for the terminal, a section of the page.

use super::{RandomOutcome, RandomVerdict};
use crate::ground::markdown::table;
use crate::render::text::percent;

/// Iterations that most accepted increments take less than.
const FEW_ITERATIONS: usize = 60;

fn words(outcome: &RandomOutcome) -> &str {
    match &outcome.verdict {
        RandomVerdict::Solved => "solved",
        RandomVerdict::Doubted { why }
        | RandomVerdict::Refused { why }
        | RandomVerdict::Wrong { why }
        | RandomVerdict::Unexplained { why } => why,
        RandomVerdict::Panicked => "it panicked",
    }
}

fn mark(outcome: &RandomOutcome) -> &'static str {
    match outcome.verdict {
        RandomVerdict::Solved => "solved",
        RandomVerdict::Doubted { .. } => "doubted",
        RandomVerdict::Refused { .. } => "refused",
        RandomVerdict::Wrong { .. } => "WRONG",
        RandomVerdict::Unexplained { .. } => "UNEXPLAINED",
        RandomVerdict::Panicked => "PANICKED",
    }
}

/// The head of the lines.
pub fn head() -> String {
    format!(
        "{:11} {:18} {:>10} {:>12} {:>7}  what came of it",
        "", "case", "iterations", "an increment", "s"
    )
}

/// A line for the terminal.
pub fn line(outcome: &RandomOutcome) -> String {
    format!(
        "{:11} {:18} {:>10} {:>12} {:>7.2}  {}",
        mark(outcome),
        outcome.name,
        outcome.iterations,
        outcome.most,
        outcome.seconds,
        words(outcome)
    )
}

/// How many ended how, in words.
pub fn tally(outcomes: &[RandomOutcome]) -> String {
    let count = |what: &dyn Fn(&RandomOutcome) -> bool| outcomes.iter().filter(|o| what(o)).count();
    let marked = |name: &'static str| count(&|o| mark(o) == name);
    let solved = count(&RandomOutcome::is_solved);
    let few = count(&|o| o.is_solved() && o.most < FEW_ITERATIONS);
    let share = |part: usize, of: usize| percent(part as f64 / of.max(1) as f64);
    let mut times: Vec<f64> = outcomes.iter().map(|o| o.seconds).collect();
    times.sort_by(f64::total_cmp);
    let time = |share: f64| {
        let at = (share * times.len() as f64) as usize;
        times
            .get(at.min(times.len().saturating_sub(1)))
            .copied()
            .unwrap_or(0.0)
    };
    format!(
        "{} cases: {solved} solved (of {} Brinell says that the mesh is too coarse), {} refused for a reason that is confirmed, {} unexplained ({}), {} wrong, \
         {} panicked. {} of the solved take fewer than {FEW_ITERATIONS} iterations in any increment. Seconds: median \
         {:.1}, nine of ten {:.1}, longest {:.1}.",
        outcomes.len(),
        marked("doubted"),
        marked("refused"),
        marked("UNEXPLAINED"),
        share(marked("UNEXPLAINED"), outcomes.len()),
        marked("WRONG"),
        marked("PANICKED"),
        share(few, solved),
        time(0.5),
        time(0.9),
        time(1.0),
    )
}

/// The section of `docs/stability.md`: what came of the cases that these arguments draw, with those by name that
/// went wrong.
pub fn section(arguments: &str, sets: &[(&str, Vec<RandomOutcome>)]) -> String {
    let mut text = format!(
        "Written by `brinell verify --suite random {arguments} --write`; do not edit. Bearings and stacks of\n\
         blocks are drawn by the seed, whatever comes of them. Each is solved, or refused for a reason that is\n\
         known without the solver: statics says that it cannot stand, a bound of the limit load that plastic\n\
         steel cannot carry it, rings and columns that give way that a body turns too far. All else is unexplained.\n\
         Stacks are also solved turned, in other units and numbered otherwise, and have to give the same to\n\
         1e-6; and with penalties of 0.01 and 100 and divided, to 1e-5. Where increments end elsewhere, they may\n\
         differ by twice what increments are said to be worth.\n"
    );
    for (what, outcomes) in sets {
        text.push_str(&format!("\n### {what}\n\n{}\n", tally(outcomes)));
        let failed: Vec<&RandomOutcome> = outcomes.iter().filter(|o| !o.holds()).collect();
        if failed.is_empty() {
            continue;
        }
        let headings = ["", "case", "iterations", "s", "what came of it"];
        let rows = failed.into_iter().map(|o| {
            [
                mark(o).to_owned(),
                o.name.clone(),
                o.iterations.to_string(),
                format!("{:.1}", o.seconds),
                words(o).to_owned(),
            ]
        });
        text.push_str(&format!("\n{}", table(headings, rows)));
    }
    text
}
