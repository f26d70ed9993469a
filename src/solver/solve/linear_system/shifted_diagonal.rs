//! The share of the diagonal that keeps factors positive definite.

use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::solve::params::FACTOR_SHIFT;

/// Makes the diagonal of `matrix` larger by [`FACTOR_SHIFT`], and returns what it was.
pub fn shift_diagonal(pattern: &Pattern, matrix: &mut SymmetricMatrix) -> Vec<f64> {
    let diagonal = pattern.diagonal(matrix);
    for (start, d) in pattern.columns.iter().zip(&diagonal) {
        matrix.values[*start as usize] = d * (1.0 + FACTOR_SHIFT);
    }
    diagonal
}

/// Sets the diagonal of `matrix`.
pub fn set_diagonal(pattern: &Pattern, matrix: &mut SymmetricMatrix, diagonal: &[f64]) {
    for (start, d) in pattern.columns.iter().zip(diagonal) {
        matrix.values[*start as usize] = *d;
    }
}
