//! A point on the path of loading.

use crate::solver::contact::law::Node;
use serde::{Deserialize, Serialize};

/// Where the load history stands and what the unknowns are there.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Point {
    /// Index of the step.
    pub step: usize,
    /// Share of the step that is done.
    pub time: f64,
    /// The kept unknowns: displacements, and motions of rigid planes.
    pub x: Vec<f64>,
    /// Contact nodes, row by row.
    pub nodes: Vec<Node>,
    /// Is friction solved with caution, see [`crate::solver::contact::law`]?
    pub cautious: bool,
}
