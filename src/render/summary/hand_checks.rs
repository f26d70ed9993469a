//! What a checker can recompute by hand, in the summary.

use serde::Serialize;

/// A figure by a formula that a pocket calculator does, and what the run found.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct HandCheck {
    /// The quantity, with its unit.
    pub what: String,
    /// The interface, or the body.
    #[serde(rename = "where")]
    pub place: String,
    /// The formula, with its numbers.
    pub formula: String,
    pub by_hand: f64,
    /// What the run found; null where it has no such figure.
    pub found: Option<f64>,
    /// Its estimated error, in its unit.
    pub error: Option<f64>,
    /// Why the two need not agree to the last digit.
    pub differs: &'static str,
}
