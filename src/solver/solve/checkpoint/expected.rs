//! The working set: what the condensed system is prepared for.

use serde::{Deserialize, Serialize};

/// What a model is prepared for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Expected {
    /// Contact is integrated up to this initial gap,
    pub reach: f64,
    /// and may close up to this much more than the least gap of its pair.
    pub contact: f64,
    /// Elements that may flow, ascending.
    pub flow: Vec<u32>,
    /// Was the model found too large for one factor?
    pub divided: bool,
}
