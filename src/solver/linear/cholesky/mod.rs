//! Sparse Cholesky factor A = L Lᵀ on a fixed pattern and order.
//!
//! Structure and dense kernels are faer's. So is the numeric factor on one thread; on more, `subtrees` shares
//! the work out.

mod analysis;
mod entries;
mod error;
mod number;
mod numeric;
mod scaling;
mod subtrees;
mod supernode;
#[cfg(test)]
pub(super) mod tests;
mod tree;
mod triangles;

use super::ordering::{self, Block};
use super::pages::Pages;
use super::sparse::{Pattern, SymmetricMatrix};
pub(super) use analysis::{analyse, structure, supernodal_work};
pub use error::FactorError;
use faer::sparse::linalg::cholesky::{self as sparse, SymbolicCholeskyRaw};
pub use number::Number;
pub(super) use numeric::{Eliminated, eliminate, numeric_alone, solve};
use numeric::{numeric, order};
use rayon::prelude::*;
use scaling::{scale, scaled};
use std::sync::OnceLock;
use subtrees::Plan;
pub(super) use tree::Tree;
pub(super) use triangles::Triangles;

/// Symbolic work that is done once a pattern: order and structure of the factor.
pub struct Symbolic {
    inner: sparse::SymbolicCholesky<u32>,
    /// Made at the first factorisation on several threads.
    plan: OnceLock<Plan>,
}

/// A numeric factor, of the matrix scaled to a diagonal of one.
pub struct Factor<T> {
    values: Pages<T>,
    /// One over the root of the matrix's diagonal.
    scale: Vec<f64>,
}

impl Symbolic {
    /// Orders the pattern block by block and finds the structure of its factor.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(pattern: &Pattern, blocks: &[Block]) -> Result<Self, FactorError> {
        let forward = ordering::blockwise(pattern, blocks);
        let inner = analyse(structure(pattern), &forward, Default::default())?;
        Ok(Self {
            inner,
            plan: OnceLock::new(),
        })
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.inner.len_val()
    }

    /// Multiplications that a factor takes.
    pub fn work(&self) -> f64 {
        let squared = |height: usize| 0.5 * (height as f64).powi(2);
        match self.inner.raw() {
            SymbolicCholeskyRaw::Supernodal(nodes) => supernodal_work(nodes, usize::MAX),
            SymbolicCholeskyRaw::Simplicial(columns) => {
                let ends = columns.col_ptr().windows(2);
                ends.map(|ends| squared((ends[1] - ends[0]) as usize)).sum()
            }
        }
    }

    /// Factorises `matrix`, reusing the storage of `old`.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the matrix is not positive definite.
    pub fn factorise<T: Number>(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        old: Option<Factor<T>>,
    ) -> Result<Factor<T>, FactorError> {
        let mut values = match old {
            Some(factor) => factor.values,
            None => Pages::new(self.inner.len_val()).map_err(|_| FactorError::Memory)?,
        };
        let scale = scale(pattern, matrix)?;
        let entries = scaled(pattern, matrix, &scale);
        numeric(&self.inner, &self.plan, pattern, &entries, &mut values)?;
        Ok(Factor { values, scale })
    }

    /// Solves A x = b in place, on all threads of the pool where that pays.
    pub fn solve<T: Number>(&self, factor: &Factor<T>, x: &mut [f64]) {
        /// Entries of a factor that are worth several threads.
        const LEAST_ENTRIES_FOR_THREADS: usize = 1 << 20;
        let pays = self.factor_entries() >= LEAST_ENTRIES_FOR_THREADS;
        let plan = self.plan.get().filter(|_| pays);
        let (SymbolicCholeskyRaw::Supernodal(nodes), Some(plan)) = (self.inner.raw(), plan) else {
            return self.solve_many(factor, x, 1);
        };
        let order = order(&self.inner).iter().map(|e| *e as usize);
        let mut y: Vec<T> = (order.clone())
            .map(|e| T::rounded(x[e] * factor.scale[e]))
            .collect();
        plan.solve(nodes, &factor.values, &mut y);
        for (e, y) in order.zip(y) {
            x[e] = y.widened() * factor.scale[e];
        }
    }

    /// Solves A X = B in place, for `count` columns one after the other, on all threads of the pool.
    pub fn solve_many<T: Number>(&self, factor: &Factor<T>, x: &mut [f64], count: usize) {
        let scale = || factor.scale.iter().cycle();
        let columns = count.div_ceil(rayon::current_num_threads()).max(1);
        x.par_chunks_mut(columns * factor.scale.len().max(1))
            .for_each(|x| {
                let mut y: Vec<T> = (x.iter().zip(scale()))
                    .map(|(x, s)| T::rounded(x * s))
                    .collect();
                let count = y.len() / factor.scale.len();
                solve(&self.inner, &factor.values, &mut y, count);
                let solved = y.iter().zip(scale()).map(|(y, s)| y.widened() * s);
                x.iter_mut().zip(solved).for_each(|(x, y)| *x = y);
            });
    }
}
