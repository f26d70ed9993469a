//! What came of a case, beside what was expected.

use super::entry::Extreme;
use crate::product::job::JobError;
use crate::render::text::significant;
use miette::Diagnostic;
use serde_json::Value;

/// How a case ended.
#[derive(Debug, Clone, PartialEq)]
pub enum ExtremeVerdict {
    /// As expected: solved, with the largest relative error of what was checked.
    Solved {
        error: f64,
    },
    /// As expected: refused, in these words.
    Refused {
        message: String,
    },
    /// Solved, but this is wrong.
    Wrong {
        why: String,
    },
    /// Refused, but otherwise than expected.
    Unexpected {
        message: String,
    },
    /// Stopped when it had used up its iterations.
    Endless,
    Panicked,
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct ExtremeOutcome {
    pub what: String,
    /// In words.
    pub expected: String,
    pub verdict: ExtremeVerdict,
    pub iterations: usize,
    pub cut_backs: usize,
    pub seconds: f64,
}

impl ExtremeOutcome {
    /// Did it end as expected?
    pub fn holds(&self) -> bool {
        matches!(
            self.verdict,
            ExtremeVerdict::Solved { .. } | ExtremeVerdict::Refused { .. }
        )
    }
}

/// What a case is expected to come to, in words.
pub(super) fn expected(case: &Extreme) -> String {
    if !case.refused.is_empty() {
        return format!("refused: {}", case.refused.join(" or "));
    }
    let values = case.expect.iter();
    let values: Vec<String> = values
        .map(|(at, value)| format!("{} {}", name(at), significant(*value, 5)))
        .collect();
    format!("{} ({})", values.join(", "), case.source)
}

/// The last part of a JSON pointer.
fn name(pointer: &str) -> String {
    let last = pointer.rsplit('/').next().unwrap_or(pointer);
    last.replace('_', " ")
}

/// The verdict on a case that was solved.
pub(super) fn solved(case: &Extreme, summary: &Value) -> ExtremeVerdict {
    if case.expect.is_empty() {
        return ExtremeVerdict::Wrong {
            why: "it was solved".to_owned(),
        };
    }
    if summary["converged"] != Value::Bool(true) {
        return ExtremeVerdict::Wrong {
            why: "it did not get to its end".to_owned(),
        };
    }
    let mut worst: f64 = 0.0;
    for (pointer, expected) in &case.expect {
        let found = summary.pointer(pointer).and_then(Value::as_f64);
        let Some(found) = found else {
            return ExtremeVerdict::Wrong {
                why: format!("{} is missing", name(pointer)),
            };
        };
        let scale = if *expected == 0.0 {
            1.0
        } else {
            expected.abs()
        };
        let error = (found - expected).abs() / scale;
        if !(error <= case.within) {
            return ExtremeVerdict::Wrong {
                why: format!("{} is {}", name(pointer), significant(found, 6)),
            };
        }
        worst = worst.max(error);
    }
    ExtremeVerdict::Solved { error: worst }
}

/// The verdict on a case that was not.
pub(super) fn refused(case: &Extreme, error: &JobError) -> ExtremeVerdict {
    let code = error.code().map(|code| code.to_string());
    let code = code.unwrap_or_default();
    let message = error.to_string();
    let as_expected = |known: &String| code == format!("brinell::{known}");
    match case.refused.iter().any(as_expected) {
        true => ExtremeVerdict::Refused { message },
        false => ExtremeVerdict::Unexpected {
            message: format!("{code}: {message}"),
        },
    }
}
