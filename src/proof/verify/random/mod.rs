//! Bearings and stacks of blocks that nobody has chosen: each is solved, or refused for a reason that a check
//! without the solver confirms.
//!
//! Whether a case can be in balance, and whether plastic steel can carry its load, is known from statics and
//! from a bound of the limit load (`bearing`, `scene`), so that a refusal is not simply believed.

mod bearing;
mod known;
mod outcome;
mod page;
mod scene;
mod stack;
mod watch;

pub use outcome::{Outcome, Verdict};
pub use page::{head, line, section, tally};

use crate::case;
use crate::product::job::{self, Options};
use std::panic::{AssertUnwindSafe, catch_unwind};
use watch::Watch;

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Bearings of the template, on the mesh of the report.
    Bearing,
    /// Two or three blocks.
    Stack,
}

impl Kind {
    /// What they are, as a heading.
    pub fn title(self) -> &'static str {
        match self {
            Self::Bearing => "Bearings on `report-like`",
            Self::Stack => "Stacks of two or three blocks",
        }
    }

    /// The case file of case `number` of a seed, where it has one.
    pub fn text(self, seed: u64, number: usize) -> Option<String> {
        match self {
            Self::Bearing => Some(bearing::bearing(seed, number).0.text()),
            Self::Stack => None,
        }
    }

    /// What case `number` of a seed is called.
    pub fn name(self, seed: u64, number: usize) -> String {
        match self {
            Self::Bearing => format!("random-{seed}-{number:03}"),
            Self::Stack => format!("stack-{seed}-{number:03}"),
        }
    }
}

/// How many of each are drawn for a page.
pub const COUNT: [(Kind, usize); 2] = [(Kind::Bearing, 300), (Kind::Stack, 200)];

/// Draws case `number` of a seed and solves it.
pub fn run(kind: Kind, seed: u64, number: usize) -> Outcome {
    let mut watch = Watch::start();
    let solve = AssertUnwindSafe(|| match kind {
        Kind::Bearing => solve_bearing(seed, number, &mut watch),
        Kind::Stack => stack::solve(seed, number, &mut watch),
    });
    let verdict = catch_unwind(solve).unwrap_or(Verdict::Panicked);
    Outcome::new(kind.name(seed, number), verdict, &watch)
}

fn solve_bearing(seed: u64, number: usize, watch: &mut Watch) -> Verdict {
    let (drawn, known) = bearing::bearing(seed, number);
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
