//! Bearings and stacks of blocks that nobody has chosen: each is solved, or refused for a reason that a check
//! without the solver confirms.
//!
//! Whether a case can be in balance, and whether plastic steel can carry its load, is known from statics and
//! from a bound of the limit load (`bearings`, `stack`), so that a refusal is not simply believed.

mod bearings;
mod kind;
mod known;
mod outcome;
mod page;
mod stack;
mod watch;

pub use kind::{COUNT, RandomKind};
pub use outcome::{RandomOutcome, RandomVerdict};
pub use page::{head, line, section, tally};

use crate::case;
use crate::product::job::{self, Options};
use std::panic::{AssertUnwindSafe, catch_unwind};
use watch::RandomWatch;

/// The case file of case `number` of a seed, where it has one.
pub fn case_text(kind: RandomKind, seed: u64, number: usize) -> Option<String> {
    match kind {
        RandomKind::Bearing => Some(bearings::draw(seed, number).0.text()),
        RandomKind::Stack => None,
    }
}

/// Draws case `number` of a seed and solves it.
pub fn run(kind: RandomKind, seed: u64, number: usize) -> RandomOutcome {
    let mut watch = RandomWatch::start();
    let solve = AssertUnwindSafe(|| match kind {
        RandomKind::Bearing => solve_bearing(seed, number, &mut watch),
        RandomKind::Stack => stack::solve(seed, number, &mut watch),
    });
    let verdict = catch_unwind(solve).unwrap_or(RandomVerdict::Panicked);
    RandomOutcome::new(kind.name(seed, number), verdict, &watch)
}

fn solve_bearing(seed: u64, number: usize, watch: &mut RandomWatch) -> RandomVerdict {
    let (drawn, known) = bearings::draw(seed, number);
    let name = format!("{}.toml", drawn.name);
    let case = match case::parse(&name, &drawn.text()) {
        Ok(case) => case,
        Err(error) => return outcome::refused(&known, &error),
    };
    match job::run(&case, &Options::default(), watch) {
        Ok(outcome) if outcome.interrupted || !outcome.summary.answer.converged => outcome::late(),
        Ok(outcome) => {
            let overlap = |limit: &String| limit.starts_with("penetration");
            let missed = outcome.missed_limits(&case).into_iter();
            let (doubts, failed): (Vec<_>, Vec<_>) = missed.partition(overlap);
            let words = |limits: Vec<String>| (!limits.is_empty()).then(|| limits.join("; "));
            outcome::solved(&known, words(failed), words(doubts))
        }
        Err(error) => outcome::refused(&known, &error),
    }
}
