//! One entry of a suite of extreme cases.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

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
