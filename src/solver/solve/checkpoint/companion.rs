//! The second solution, in increments twice as large, as it is saved.

use crate::solver::solve::checkpoint::plastic::Plastic;
use crate::solver::solve::checkpoint::point::Point;
use serde::{Deserialize, Serialize};

/// It goes on only with a model of the same unknowns and contact rows.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct KeptCompanion {
    pub point: Point,
    pub plastic: Plastic,
    pub slip_origin: Vec<[f64; 2]>,
    pub slip: Vec<f64>,
    pub passed: Vec<Point>,
}

impl KeptCompanion {
    /// Its steps and its plastic elements, for whoever checks what was read.
    pub fn contents(&self) -> impl Iterator<Item = (usize, u32)> {
        let points = self.passed.iter().chain([&self.point]);
        let steps = points.map(|p| (p.step, 0));
        steps.chain(self.plastic.iter().map(|(element, _)| (0, *element)))
    }
}
