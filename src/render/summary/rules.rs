//! Design rules beside the loads of a bearing, and what its steel does, in the summary.

use crate::analytic::rules::{Judged, Rule};
use serde::Serialize;

/// What the design rules say, and what the steel then does.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct RuleSheet {
    /// Every rule, also those that do not apply, which say why.
    pub rules: Vec<JudgedRule>,
    /// Every body, where some steel can yield.
    pub steel: Vec<SteelAfter>,
    /// What was taken for granted of all rules.
    pub notes: Vec<String>,
}

/// A rule and what it says of two loads per length.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct JudgedRule {
    /// The rule and its limit, for the line that it is used most by.
    #[serde(flatten)]
    pub rule: Rule,
    /// Under the load spread evenly over the length that bears.
    pub even: Option<Judged>,
    /// The interface of the line that has it; none of a single roller.
    pub even_line: Option<String>,
    /// Under the largest load per length.
    pub largest: Option<Judged>,
    /// The interface of the line that has it; none of a single roller.
    pub largest_line: Option<String>,
}

/// What the steel of a body does under the load, and keeps of it.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct SteelAfter {
    pub body: String,
    /// Largest equivalent plastic strain.
    pub peeq_max: f64,
    /// Largest equivalent plastic strain away from loaded edges.
    pub peeq_away: f64,
    /// Volume that has yielded, and its share of the body.
    pub yielded_volume: f64,
    pub yielded_share: f64,
    /// Deepest dent that stays when the load is taken off; none where the case does not.
    pub dent: Option<f64>,
    /// The surface that it is in.
    pub dent_in: Option<String>,
    /// The same over the diameter of the roller, beside the 1e-4 of ISO 76.
    pub dent_over_diameter: Option<f64>,
}
