//! A correction, and what is left to be solved for while it is sought.

use crate::solver::linear::krylov::KrylovOutcome;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;

/// How a correction was found.
pub struct Correction {
    pub dx: Vec<f64>,
    pub directions: usize,
    pub refactored: bool,
}

/// A correction that is being sought: the sum of what has been found, and what is left to be solved for.
pub struct Sought {
    pub residual: Vec<f64>,
    /// As a share of the residual.
    pub tolerance: f64,
    pub found: Correction,
}

impl Sought {
    /// For the residual of `evaluation`, nothing found yet.
    pub fn new(evaluation: &Evaluation, (model, tolerance): (&Model, f64)) -> Self {
        Self {
            residual: evaluation.residual.clone(),
            tolerance,
            found: Correction {
                dx: vec![0.0; model.dofs.len()],
                directions: 0,
                refactored: false,
            },
        }
    }

    /// Takes what was found for the residual. Is it enough?
    pub fn take(
        &mut self,
        dx: &[f64],
        outcome: &KrylovOutcome,
        multiply: impl Fn(&[f64], &mut [f64]),
    ) -> bool {
        (self.found.dx.iter_mut().zip(dx)).for_each(|(x, d)| *x += d);
        self.found.directions += outcome.iterations;
        let enough = outcome.residual <= self.tolerance;
        if !enough {
            let mut product = vec![0.0; dx.len()];
            multiply(dx, &mut product);
            (self.residual.iter_mut().zip(&product)).for_each(|(r, p)| *r -= p);
            self.tolerance /= outcome.residual;
        }
        enough
    }
}
