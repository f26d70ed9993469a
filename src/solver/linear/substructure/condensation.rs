//! Which unknowns are eliminated, in which order, and the structure of the factor.

use crate::solver::linear::cholesky::{FactorError, analyse, structure, supernodal_work};
use crate::solver::linear::ordering;
use crate::solver::linear::sparse::Pattern;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{self as sparse, SymbolicCholesky, SymbolicCholeskyRaw};

/// Order and structure of the factor, before any number.
pub struct Condensation {
    /// Structure of the factor.
    pub(super) inner: SymbolicCholesky<u32>,
    /// Equations in the order of elimination, the kept ones last and ascending.
    pub(super) order: Vec<u32>,
    /// Number of equations that are eliminated.
    pub(super) eliminated: usize,
}

impl Condensation {
    /// Keeps the equations of the vertices marked in `kept`.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(pattern: &Pattern, kept: &[bool]) -> Result<Self, FactorError> {
        let (order, eliminated) = ordering::with_last(pattern, kept);
        let params = sparse::CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let inner = analyse(structure(pattern), &order, params)?;
        Ok(Self {
            inner,
            order,
            eliminated,
        })
    }

    /// Multiplications that the elimination takes.
    pub fn work(&self) -> f64 {
        supernodal_work(self.supernodal(), self.eliminated)
    }

    /// Number of equations kept.
    pub fn kept(&self) -> usize {
        self.order.len() - self.eliminated
    }

    /// The kept equations, ascending.
    pub fn kept_equations(&self) -> &[u32] {
        &self.order[self.eliminated..]
    }

    pub(super) fn supernodal(&self) -> &SymbolicSupernodalCholesky<u32> {
        match self.inner.raw() {
            SymbolicCholeskyRaw::Supernodal(s) => s,
            SymbolicCholeskyRaw::Simplicial(_) => unreachable!("supernodal was asked for"),
        }
    }
}
