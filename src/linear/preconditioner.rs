//! What a Krylov method is preconditioned with: a factor of the whole, or of many small parts.

use super::cholesky::{Factor, FactorError, Symbolic};
use super::schwarz::{Schwarz, SchwarzFactor};
use super::sparse::{Pattern, SymmetricMatrix};

/// Symbolic work, done once a pattern.
pub enum Preconditioner {
    Direct(Box<Symbolic>),
    Schwarz(Box<Schwarz>),
}

/// The numbers of one matrix.
pub enum Prepared {
    Direct(Factor),
    Schwarz(Box<SchwarzFactor>),
}

impl Preconditioner {
    /// Prepares for `matrix`, reusing `old`.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the matrix is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        old: Option<Prepared>,
    ) -> Result<Prepared, FactorError> {
        match self {
            Self::Direct(symbolic) => {
                let old = match old {
                    Some(Prepared::Direct(factor)) => Some(factor),
                    _ => None,
                };
                symbolic
                    .factorise(pattern, matrix, old)
                    .map(Prepared::Direct)
            }
            Self::Schwarz(schwarz) => {
                let old = match old {
                    Some(Prepared::Schwarz(factor)) => Some(*factor),
                    _ => None,
                };
                (schwarz.factorise(pattern, matrix, old)).map(|f| Prepared::Schwarz(Box::new(f)))
            }
        }
    }

    /// Replaces `x` by the preconditioned x; `multiply(x, y)` sets y = A x.
    pub fn apply(
        &self,
        pattern: &Pattern,
        prepared: &Prepared,
        multiply: impl Fn(&[f64], &mut [f64]),
        x: &mut [f64],
    ) {
        match (self, prepared) {
            (Self::Direct(symbolic), Prepared::Direct(factor)) => symbolic.solve(factor, x),
            (Self::Schwarz(schwarz), Prepared::Schwarz(factor)) => {
                schwarz.apply(pattern, factor, multiply, x)
            }
            _ => unreachable!("prepared by the same preconditioner"),
        }
    }

    /// Replaces the columns of a matrix by A⁻¹ times these, where there is a factor of the whole.
    pub fn solve_many(&self, prepared: &Prepared, x: &mut [f64], count: usize) {
        if let (Self::Direct(symbolic), Prepared::Direct(factor)) = (self, prepared) {
            symbolic.solve_many(factor, x, count);
        }
    }

    /// Entries of all factors.
    pub fn factor_entries(&self) -> usize {
        match self {
            Self::Direct(symbolic) => symbolic.factor_entries(),
            Self::Schwarz(schwarz) => schwarz.factor_entries(),
        }
    }
}
