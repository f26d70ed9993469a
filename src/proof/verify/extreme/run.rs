//! Running an extreme case as a user's case is run, within its budget of iterations.

use super::entry::Extreme;
use super::outcome::{self, ExtremeOutcome, ExtremeVerdict};
use crate::case::{self, variant};
use crate::product::job::{self, JobError, Options};
use crate::solver::solve::{Iteration, Observer};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Instant;

/// Counts what a run does, and ends it when it has done too much.
#[derive(Debug, Default)]
struct IterationBudget {
    iterations: usize,
    cut_backs: usize,
    most: usize,
}

impl Observer for IterationBudget {
    fn iteration(&mut self, _: &Iteration) {
        self.iterations += 1;
    }

    fn message(&mut self, text: &str) {
        self.cut_backs += usize::from(text.starts_with("cut back"));
    }

    fn cancelled(&self) -> bool {
        self.iterations >= self.most
    }
}

impl Extreme {
    /// Runs the case; `folder` is that of the suite.
    pub fn run(&self, folder: &Path) -> ExtremeOutcome {
        let start = Instant::now();
        let mut budget = IterationBudget {
            most: self.iterations,
            ..IterationBudget::default()
        };
        let run = catch_unwind(AssertUnwindSafe(|| self.solve(folder, &mut budget)));
        let verdict = match run {
            Err(_) => ExtremeVerdict::Panicked,
            Ok(_) if budget.cancelled() => ExtremeVerdict::Endless,
            Ok(Ok(summary)) => outcome::solved(self, &summary),
            Ok(Err(error)) => outcome::refused(self, &error),
        };
        ExtremeOutcome {
            what: self.what.clone(),
            expected: outcome::expected(self),
            verdict,
            iterations: budget.iterations,
            cut_backs: budget.cut_backs,
            seconds: start.elapsed().as_secs_f64(),
        }
    }

    fn solve(
        &self,
        folder: &Path,
        budget: &mut IterationBudget,
    ) -> Result<serde_json::Value, JobError> {
        let path = folder.join(&self.base);
        let text =
            std::fs::read_to_string(&path).map_err(|error| JobError::folder(&path, error))?;
        let text = variant::changed(&text, &self.set);
        let case = case::parse(&path.to_string_lossy(), &text)?;
        let outcome = job::run(&case, &Options::default(), budget)?;
        Ok(serde_json::to_value(outcome.summary).unwrap_or_default())
    }
}
