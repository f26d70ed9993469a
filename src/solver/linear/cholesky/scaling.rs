//! A matrix scaled to a diagonal of one.
//!
//! Contact penalties and the rigid motions of bodies differ by many powers of ten. Scaled from both sides by one over
//! the root of the diagonal, D⁻½ A D⁻½, the entries are within one, which single precision can hold.

use super::error::FactorError;
use super::number::Number;
use crate::solver::linear::sparse::{ENTRIES_PER_TASK, Pattern, SymmetricMatrix};
use rayon::prelude::*;

/// One over the root of each entry of the diagonal.
///
/// # Errors
/// [`FactorError::NotPositiveDefinite`] where an entry is not positive.
pub(super) fn scale(pattern: &Pattern, matrix: &SymmetricMatrix) -> Result<Vec<f64>, FactorError> {
    let diagonal = pattern.diagonal(matrix).into_iter().enumerate();
    diagonal
        .map(|(equation, d)| match d > 0.0 {
            true => Ok(1.0 / d.sqrt()),
            false => Err(FactorError::NotPositiveDefinite { equation }),
        })
        .collect()
}

/// The entries of `matrix`, scaled from both sides.
pub(super) fn scaled<T: Number>(
    pattern: &Pattern,
    matrix: &SymmetricMatrix,
    scale: &[f64],
) -> Vec<T> {
    let mut entries = vec![T::rounded(0.0); matrix.values.len()];
    let tasks = entries.par_chunks_mut(ENTRIES_PER_TASK).enumerate();
    tasks.for_each(|(task, entries)| {
        let start = task * ENTRIES_PER_TASK;
        let mut column = pattern.columns.partition_point(|s| *s as usize <= start) - 1;
        for (at, entry) in (start..).zip(entries) {
            while pattern.columns[column + 1] as usize <= at {
                column += 1;
            }
            let row = pattern.rows[at] as usize;
            *entry = T::rounded(matrix.values[at] * scale[column] * scale[row]);
        }
    });
    entries
}
