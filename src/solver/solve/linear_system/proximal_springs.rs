//! Springs from every unknown to where it stood, see [`crate::solver::solve::newton`].

use crate::solver::linear::sparse::SymmetricMatrix;
use crate::solver::solve::model::system::Model;

/// A spring from every unknown to where it stood.
pub struct ProximalSprings {
    pub stiffness: Vec<f64>,
    pub at: Vec<f64>,
}

impl ProximalSprings {
    /// Adds the forces of the springs to a residual at `x`.
    pub fn pull(&self, residual: &mut [f64], x: &[f64]) {
        let springs = self.stiffness.iter().zip(x).zip(&self.at);
        for (r, ((k, x), at)) in residual.iter_mut().zip(springs) {
            *r -= k * (x - at);
        }
    }

    /// Adds the springs to a tangent.
    pub fn stiffen(&self, model: &Model, matrix: &mut SymmetricMatrix) {
        for (start, k) in model.pattern.columns.iter().zip(&self.stiffness) {
            matrix.values[*start as usize] += k;
        }
    }
}
