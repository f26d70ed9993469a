//! What a case takes for granted, echoed with its results.

use serde::Serialize;

/// One point that the source of a study leaves open, and what this run takes for it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumption {
    /// The key of the case file that changes it.
    pub key: String,
    /// What is taken.
    pub value: String,
    /// Why.
    pub why: String,
    /// Was it written in the case file (true), or is it the default?
    pub given: bool,
}

impl Assumption {
    pub(super) fn new(key: &str, value: impl Into<String>, why: &str, given: bool) -> Self {
        Self {
            key: key.to_string(),
            value: value.into(),
            why: why.to_string(),
            given,
        }
    }

    pub(super) fn default(key: &str, value: impl Into<String>, why: &str) -> Self {
        Self::new(key, value, why, false)
    }
}
