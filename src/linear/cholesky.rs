//! Sparse Cholesky factor (faer, supernodal) on a fixed pattern and order.

use super::ordering::{self, Block};
use super::sparse::{Pattern, SymmetricMatrix};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky as sparse;
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// Symbolic work that is done once a pattern: order and structure of the factor.
pub struct Symbolic {
    inner: sparse::SymbolicCholesky<u32>,
}

/// A numeric factor.
pub struct Factor {
    values: Vec<f64>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FactorError {
    #[error("not enough memory for the factor")]
    Memory,
    #[error("the matrix is not positive definite at equation {equation}")]
    NotPositiveDefinite { equation: usize },
}

impl Symbolic {
    /// Orders the pattern block by block and finds the structure of its factor.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(pattern: &Pattern, blocks: &[Block]) -> Result<Self, FactorError> {
        let forward = ordering::blockwise(pattern, blocks);
        let mut inverse = vec![0u32; forward.len()];
        for (k, equation) in forward.iter().enumerate() {
            inverse[*equation as usize] = k as u32;
        }
        let order = PermRef::new_checked(&forward, &inverse, forward.len());
        let inner = sparse::factorize_symbolic_cholesky(
            structure(pattern),
            Side::Lower,
            sparse::SymmetricOrdering::Custom(order),
            Default::default(),
        )
        .map_err(|_| FactorError::Memory)?;
        Ok(Self { inner })
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.inner.len_val()
    }

    /// Factorises `matrix`, reusing the storage of `old`.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the matrix is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        old: Option<Factor>,
    ) -> Result<Factor, FactorError> {
        let mut values = match old {
            Some(factor) => factor.values,
            None => {
                let mut values = Vec::new();
                values
                    .try_reserve_exact(self.inner.len_val())
                    .map_err(|_| FactorError::Memory)?;
                values.resize(self.inner.len_val(), 0.0);
                values
            }
        };
        let par = parallelism();
        let need = self
            .inner
            .factorize_numeric_llt_scratch::<f64>(par, Default::default());
        let mut memory = MemBuffer::try_new(need).map_err(|_| FactorError::Memory)?;
        self.inner
            .factorize_numeric_llt(
                &mut values,
                SparseColMatRef::new(structure(pattern), &matrix.values),
                Side::Lower,
                LltRegularization::default(),
                par,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|error| match error {
                LltError::NonPositivePivot { index } => {
                    let order = self.inner.perm().map(|p| p.arrays().0);
                    let equation = order
                        .and_then(|o| o.get(index))
                        .map_or(index, |e| *e as usize);
                    FactorError::NotPositiveDefinite { equation }
                }
            })?;
        Ok(Factor { values })
    }

    /// Solves A x = b in place.
    pub fn solve(&self, factor: &Factor, x: &mut [f64]) {
        let need = self.inner.solve_in_place_scratch::<f64>(1, Par::Seq);
        let mut memory = MemBuffer::new(need);
        let rows = x.len();
        sparse::LltRef::new(&self.inner, &factor.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, rows, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
    }
}

pub(super) fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.len();
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.columns, None, &pattern.rows)
}

pub(super) fn parallelism() -> Par {
    match rayon::current_num_threads() {
        0 | 1 => Par::Seq,
        threads => Par::rayon(threads),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Laplacian of a chain plus one: solved against its own product.
    #[test]
    fn solves_what_it_multiplies() {
        let n = 50u32;
        let cliques: Vec<Vec<u32>> = (0..n - 1).map(|i| vec![i, i + 1]).collect();
        let pattern = Pattern::new((0..=n).collect(), cliques.iter().map(Vec::as_slice));
        let mut m = pattern.zeros();
        for c in &cliques {
            pattern.add_block(&mut m, c, |i, j| if i == j { 1.5 } else { -1.0 });
        }
        let x: Vec<f64> = (0..n).map(|i| f64::from(i).sin()).collect();
        let mut b = vec![0.0; n as usize];
        pattern.multiply(&m, &x, &mut b);
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..n)]).unwrap();
        let factor = symbolic.factorise(&pattern, &m, None).unwrap();
        symbolic.solve(&factor, &mut b);
        assert!(b.iter().zip(&x).all(|(b, x)| (b - x).abs() < 1e-12));
    }
}
