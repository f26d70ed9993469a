//! A matrix scaled to a diagonal of one.
//!
//! Contact penalties and the rigid motions of bodies differ by many powers of ten. Scaled from both sides by one over
//! the root of the diagonal, D⁻½ A D⁻½, the entries are within one, which single precision can hold.

use super::error::FactorError;
use super::number::Number;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};

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
    let mut entries = Vec::with_capacity(matrix.values.len());
    for (ends, column) in pattern.columns.windows(2).zip(scale) {
        let range = ends[0] as usize..ends[1] as usize;
        let rows = pattern.rows[range.clone()].iter();
        let values = rows.zip(&matrix.values[range]);
        entries.extend(values.map(|(row, v)| T::rounded(v * column * scale[*row as usize])));
    }
    entries
}
