//! What a Krylov method is preconditioned with: a factor of the whole, or of many small parts.

use super::cholesky::{Factor, FactorError, ReachedColumns, SparseColumn, Symbolic, Update};
use super::schwarz::{Schwarz, SchwarzFactor};
use super::sparse::{Pattern, SymmetricMatrix};

/// Symbolic work, done once a pattern.
pub enum Preconditioner {
    Direct(Box<Symbolic>),
    Schwarz(Box<Schwarz>),
}

/// The numbers of one matrix.
pub enum Prepared {
    Single(Factor<f32>),
    Double(Factor<f64>),
    Schwarz(Box<SchwarzFactor>),
}

impl Prepared {
    /// Of its numbers.
    pub fn precision(&self) -> Precision {
        match self {
            Self::Single(_) => Precision::Single,
            Self::Double(_) | Self::Schwarz(_) => Precision::Double,
        }
    }
}

/// Of a factor. What is solved for is in double precision all the same: single precision costs a direction or two more,
/// and half of the time and memory of a factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    #[default]
    Single,
    Double,
}

/// Multiplications of a factor from which on single precision pays: those of a few milliseconds.
const LEAST_WORK_FOR_SINGLE: f64 = 1e8;

impl Preconditioner {
    /// Prepares for `matrix`, which contact and flow have made of the `elastic` one, reusing `old`. A factor in single precision is tried only where that pays, and is in
    /// double precision where the matrix is not positive definite to single.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the matrix is not positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        [matrix, elastic]: [&SymmetricMatrix; 2],
        precision: Precision,
        old: Option<Prepared>,
    ) -> Result<Prepared, FactorError> {
        match self {
            Self::Direct(symbolic) => {
                let is_single =
                    precision == Precision::Single && symbolic.work() > LEAST_WORK_FOR_SINGLE;
                let (single, double) = match old {
                    Some(Prepared::Single(factor)) if is_single => (Some(factor), None),
                    Some(Prepared::Double(factor)) if !is_single => (None, Some(factor)),
                    // Two factors at once would be more memory than was asked for.
                    other => {
                        drop(other);
                        (None, None)
                    }
                };
                if is_single {
                    match symbolic.factorise(pattern, matrix, single) {
                        // Perhaps only rounding says so.
                        Err(FactorError::NotPositiveDefinite { .. }) => {}
                        result => return result.map(Prepared::Single),
                    }
                }
                symbolic
                    .factorise(pattern, matrix, double)
                    .map(Prepared::Double)
            }
            Self::Schwarz(schwarz) => {
                let old = match old {
                    Some(Prepared::Schwarz(factor)) => Some(*factor),
                    _ => None,
                };
                let factor = schwarz.factorise(pattern, matrix, elastic, old);
                factor.map(|f| Prepared::Schwarz(Box::new(f)))
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
            (Self::Direct(symbolic), Prepared::Double(factor)) => symbolic.solve(factor, x),
            (Self::Direct(symbolic), Prepared::Single(factor)) => symbolic.solve(factor, x),
            (Self::Schwarz(schwarz), Prepared::Schwarz(factor)) => {
                schwarz.apply(pattern, factor, multiply, x)
            }
            _ => unreachable!("prepared by the same preconditioner"),
        }
    }

    /// [`Symbolic::solve_updated`], where there is a factor of the whole.
    pub fn solve_updated(&self, prepared: &Prepared, x: &mut [f64], update: Option<Update>) {
        match (self, prepared) {
            (Self::Direct(symbolic), Prepared::Double(factor)) => {
                symbolic.solve_updated(factor, x, update)
            }
            (Self::Direct(symbolic), Prepared::Single(factor)) => {
                symbolic.solve_updated(factor, x, update)
            }
            _ => unreachable!("a divided matrix has no factor of the whole"),
        }
    }

    /// [`Symbolic::reach`] within the share `most` of what a new factor takes, where there is a factor of the whole.
    pub fn reach(
        &self,
        prepared: &Prepared,
        b: &[[SparseColumn; 3]],
        most: f64,
    ) -> Option<Vec<ReachedColumns>> {
        match (self, prepared) {
            (Self::Direct(symbolic), Prepared::Double(factor)) => {
                symbolic.reach(factor, b, most * symbolic.work())
            }
            (Self::Direct(symbolic), Prepared::Single(factor)) => {
                symbolic.reach(factor, b, most * symbolic.work())
            }
            _ => None,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::linear::cholesky::tests::plate;
    use crate::solver::linear::krylov;
    use crate::solver::linear::ordering::Block;

    /// A plate of springs that next to nothing holds: single precision can see it as free.
    #[test]
    fn what_is_all_but_singular_to_single_precision_is_solved() {
        const SIDE: u32 = 100;
        let (pattern, matrix) = plate(SIDE, |i, j| match (i == j, i % 3 == j % 3) {
            (true, _) => 1.0 + 1e-9,
            (false, true) => -1.0,
            _ => 0.0,
        });
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..SIDE * SIDE)]).unwrap();
        assert!(symbolic.work() > LEAST_WORK_FOR_SINGLE);
        let preconditioner = Preconditioner::Direct(Box::new(symbolic));
        let b: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
        let factor = preconditioner.factorise(&pattern, [&matrix; 2], Precision::Single, None);
        let factor = factor.unwrap();
        let multiply = |x: &[f64], y: &mut [f64]| pattern.multiply(&matrix, x, y);
        let precondition = |x: &mut [f64]| preconditioner.apply(&pattern, &factor, multiply, x);
        let (_, outcome) = krylov::solve(multiply, precondition, &b, 1e-10, 30);
        assert!(outcome.residual <= 1e-10, "{outcome:?}");
    }
}
