//! Where increments of a step have to end.

use crate::solver::solve::params::EQUAL_STEP_SHARES;
use serde::{Deserialize, Serialize};

/// Where increments of a step have to end.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::solver::solve) struct IncrementPlan {
    pub step: usize,
    pub ends: Vec<f64>,
}

impl IncrementPlan {
    /// Equal increments between two shares of `step`, none of them larger than `most`.
    pub fn even(step: usize, [from, to]: [f64; 2], most: f64) -> Self {
        let parts = ((to - from) / most - EQUAL_STEP_SHARES).ceil().max(1.0) as usize;
        let part = (to - from) / parts as f64;
        let inner = (1..parts).map(|k| from + k as f64 * part);
        Self {
            step,
            ends: inner.chain([to]).collect(),
        }
    }
}
