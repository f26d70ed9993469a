//! Sparse Cholesky factor A = L Lᵀ on a fixed pattern and order.
//!
//! Structure and dense kernels are faer's. So is the numeric factor on one thread; on more, `subtrees` shares
//! the work out.

mod analysis;
mod entries;
mod error;
mod number;
mod numeric;
mod reach;
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
pub use reach::{ReachedColumns, SparseColumn};
use scaling::{scale, scaled};
use std::sync::OnceLock;
use subtrees::Plan;
pub(super) use tree::Tree;
pub(super) use triangles::Triangles;

/// Symbolic work that is done once a pattern: order and structure of the factor.
pub struct Symbolic {
    inner: sparse::SymbolicCholesky<u32>,
    /// Made at the first factorisation, where there are supernodes.
    plan: OnceLock<Plan>,
}

/// Multiplies a vector by 1 + M between the triangles of a factor, in the order of elimination.
pub type Update<'u> = &'u dyn Fn(&mut [f64]);

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
        self.solve_updated(factor, x, None);
    }

    /// Solves with L (1 + M)⁻¹ Lᵀ in place of the factor L Lᵀ. Without supernodes there is no update.
    pub fn solve_updated<T: Number>(
        &self,
        factor: &Factor<T>,
        x: &mut [f64],
        update: Option<Update>,
    ) {
        let Some(triangles) = self.triangles(factor) else {
            let scaled = x.iter().zip(&factor.scale);
            let mut y: Vec<T> = scaled.map(|(x, s)| T::rounded(x * s)).collect();
            solve(&self.inner, &factor.values, &mut y);
            let solved = y.iter().zip(&factor.scale).map(|(y, s)| y.widened() * s);
            return x.iter_mut().zip(solved).for_each(|(x, y)| *x = y);
        };
        let order = order(&self.inner).iter().map(|e| *e as usize);
        let mut y: Vec<T> = (order.clone())
            .map(|e| T::rounded(x[e] * factor.scale[e]))
            .collect();
        triangles.reduce(&mut y);
        if let Some(update) = update {
            let mut wide: Vec<f64> = y.iter().map(|y| y.widened()).collect();
            update(&mut wide);
            (y.iter_mut().zip(wide)).for_each(|(y, wide)| *y = T::rounded(wide));
        }
        triangles.recover(&mut y);
        for (e, y) in order.zip(y) {
            x[e] = y.widened() * factor.scale[e];
        }
    }

    /// L⁻¹ B for each three columns of B with few entries, in the order of elimination. `None` where that takes more
    /// multiplications than `most`, or there are no supernodes.
    pub fn reach<T: Number>(
        &self,
        factor: &Factor<T>,
        b: &[[SparseColumn; 3]],
        most: f64,
    ) -> Option<Vec<ReachedColumns>> {
        let place = self.inner.perm()?.arrays().1;
        let scaled = |(e, value): &(usize, f64)| (place[*e] as usize, value * factor.scale[*e]);
        let scaled = |column: &SparseColumn| column.iter().map(scaled).collect();
        let b: Vec<_> = (b.iter()).map(|b| b.each_ref().map(scaled)).collect();
        self.triangles(factor)?.reach(&b, most)
    }

    /// The factor, to solve with on all threads of the pool where that pays; none without supernodes.
    fn triangles<'a, T: Number>(&'a self, factor: &'a Factor<T>) -> Option<Triangles<'a, T>> {
        /// Entries of a factor that are worth several threads.
        const LEAST_ENTRIES_FOR_THREADS: usize = 1 << 20;
        let SymbolicCholeskyRaw::Supernodal(nodes) = self.inner.raw() else {
            return None;
        };
        let pays = factor.values.len() >= LEAST_ENTRIES_FOR_THREADS;
        let threads = if pays {
            rayon::current_num_threads()
        } else {
            1
        };
        Some(self.plan.get()?.triangles(nodes, (&factor.values, threads)))
    }
}
