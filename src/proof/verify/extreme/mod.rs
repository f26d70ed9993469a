//! Cases at the edge of what can be solved, each with what is expected of it: a checked value, or a
//! refusal with a named diagnosis.
//!
//! A suite is a TOML file beside its cases. Each entry takes a base case, changes some of its keys,
//! and says what must come of it; it is run as a user's case is, from its text to its summary.

mod outcome;
mod page;

pub use outcome::{Outcome, Verdict};
pub use page::{head, line, section};

use crate::case::{self, variant};
use crate::product::job::{self, JobError, Options};
use crate::solver::solve::{Iteration, Observer};
use miette::Diagnostic;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::Instant;
use thiserror::Error;

/// One entry of a suite.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Extreme {
    /// In words: what is extreme.
    pub what: String,
    /// The case that is changed, beside the suite.
    pub base: PathBuf,
    /// New values by dotted key, such as `contact.0.friction`; arrays are counted from 0.
    #[serde(default)]
    pub set: BTreeMap<String, toml::Value>,
    /// Numbers of the summary by JSON pointer, such as `/descent`.
    #[serde(default)]
    pub expect: BTreeMap<String, f64>,
    /// Largest relative error of these.
    #[serde(default)]
    pub within: f64,
    /// Where they come from.
    #[serde(default)]
    pub source: String,
    /// Codes of the errors of which one must come instead, without `brinell::`.
    #[serde(default)]
    pub refused: Vec<String>,
    /// Newton iterations that it may take.
    #[serde(default = "budget")]
    pub iterations: usize,
    /// Does it take more than a few seconds?
    #[serde(default)]
    pub slow: bool,
}

fn budget() -> usize {
    400
}

/// The file of a suite.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Suite {
    case: Vec<Extreme>,
}

/// What is wrong with a suite, rather than with Brinell.
#[derive(Debug, Error, Diagnostic)]
pub enum SuiteError {
    #[error("the suite {} cannot be read: {error}", path.display())]
    #[diagnostic(
        code(brinell::verify::suite_file),
        help("run it in the folder of the project, where `cases/extreme` is")
    )]
    Read {
        path: PathBuf,
        error: std::io::Error,
    },
    #[error("the suite {} is not understood: {error}", path.display())]
    #[diagnostic(code(brinell::verify::suite_text))]
    Text {
        path: PathBuf,
        error: Box<toml::de::Error>,
    },
}

/// The cases of the suite at `path`.
///
/// # Errors
/// [`SuiteError`].
pub fn read(path: &Path) -> Result<Vec<Extreme>, SuiteError> {
    let text = std::fs::read_to_string(path).map_err(|error| SuiteError::Read {
        path: path.to_owned(),
        error,
    })?;
    let suite: Suite = toml::from_str(&text).map_err(|error| SuiteError::Text {
        path: path.to_owned(),
        error: Box::new(error),
    })?;
    Ok(suite.case)
}

/// Counts what a run does, and ends it when it has done too much.
#[derive(Debug, Default)]
struct Budget {
    iterations: usize,
    cut_backs: usize,
    most: usize,
}

impl Observer for Budget {
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
    pub fn run(&self, folder: &Path) -> Outcome {
        let start = Instant::now();
        let mut budget = Budget {
            most: self.iterations,
            ..Budget::default()
        };
        let run = catch_unwind(AssertUnwindSafe(|| self.solve(folder, &mut budget)));
        let verdict = match run {
            Err(_) => Verdict::Panicked,
            Ok(_) if budget.cancelled() => Verdict::Endless,
            Ok(Ok(summary)) => outcome::solved(self, &summary),
            Ok(Err(error)) => outcome::refused(self, &error),
        };
        Outcome {
            what: self.what.clone(),
            expected: outcome::expected(self),
            verdict,
            iterations: budget.iterations,
            cut_backs: budget.cut_backs,
            seconds: start.elapsed().as_secs_f64(),
        }
    }

    fn solve(&self, folder: &Path, budget: &mut Budget) -> Result<serde_json::Value, JobError> {
        let path = folder.join(&self.base);
        let text =
            std::fs::read_to_string(&path).map_err(|error| JobError::folder(&path, error))?;
        let text = variant::changed(&text, &self.set);
        let case = case::parse(&path.to_string_lossy(), &text)?;
        let outcome = job::run(&case, &Options::default(), budget)?;
        Ok(serde_json::to_value(outcome.summary).unwrap_or_default())
    }
}
