//! The numbers of a factor, and solving with it.

use super::analysis::structure;
use super::error::FactorError;
use super::number::Number;
use super::subtrees::Plan;
use super::supernode::Pivot;
use super::tree::Tree;
use crate::solver::linear::pages::Pages;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{self as sparse, SymbolicCholeskyRaw};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::traits::RealField;
use faer::{Conj, MatMut, Par, Side};
use std::sync::OnceLock;

/// Factors the matrix of these `entries` into `values`, on all threads of the pool; the `plan` is made where it is
/// missing.
pub(in crate::solver::linear) fn numeric<T: Number>(
    symbolic: &sparse::SymbolicCholesky<u32>,
    plan: &OnceLock<Plan>,
    pattern: &Pattern,
    entries: &[T],
    values: &mut [T],
) -> Result<(), FactorError> {
    if let SymbolicCholeskyRaw::Supernodal(nodes) = symbolic.raw() {
        let order = order(symbolic);
        let plan = plan.get_or_init(|| Plan::new(nodes, pattern, (order, order.len())));
        if rayon::current_num_threads() > 1 {
            return (plan.factorise(nodes, entries, values))
                .map_err(|Pivot(k)| not_positive(order, k));
        }
    }
    numeric_alone(symbolic, structure(pattern), entries, values)
}

/// Columns of a factor of which the last ones are kept, and what is left of those.
pub(in crate::solver::linear) struct Eliminated {
    pub tree: Tree,
    pub values: Pages<f64>,
    /// The lower triangle, column by column.
    pub complement: Vec<f64>,
}

/// Eliminates the first equations of `order`, `count` of them, on all threads of the pool.
///
/// # Errors
/// [`FactorError`] where memory runs out or what is eliminated is not positive definite.
pub(in crate::solver::linear) fn eliminate(
    nodes: &SymbolicSupernodalCholesky<u32>,
    (order, count): (&[u32], usize),
    (pattern, matrix): (&Pattern, &SymmetricMatrix),
) -> Result<Eliminated, FactorError> {
    let plan = Plan::new(nodes, pattern, (order, count));
    let mut values = Pages::new(plan.values()).map_err(|_| FactorError::Memory)?;
    (plan.factorise(nodes, &matrix.values, &mut values))
        .map_err(|Pivot(k)| not_positive(order, k))?;
    Ok(Eliminated {
        complement: plan.complement(nodes, &matrix.values, &values),
        tree: plan.into_tree(),
        values,
    })
}

/// Factors a lower triangle into `values` on one thread.
pub(in crate::solver::linear) fn numeric_alone<T: RealField>(
    symbolic: &sparse::SymbolicCholesky<u32>,
    structure: SymbolicSparseColMatRef<u32>,
    entries: &[T],
    values: &mut [T],
) -> Result<(), FactorError> {
    let need = symbolic.factorize_numeric_llt_scratch::<T>(Par::Seq, Default::default());
    let mut memory = MemBuffer::try_new(need).map_err(|_| FactorError::Memory)?;
    let result = symbolic.factorize_numeric_llt(
        values,
        SparseColMatRef::new(structure, entries),
        Side::Lower,
        LltRegularization::default(),
        Par::Seq,
        MemStack::new(&mut memory),
        Default::default(),
    );
    match result {
        Ok(_) => Ok(()),
        Err(LltError::NonPositivePivot { index }) => Err(not_positive(order(symbolic), index)),
    }
}

/// Equations in the order of elimination.
pub(super) fn order(symbolic: &sparse::SymbolicCholesky<u32>) -> &[u32] {
    symbolic.perm().map_or(&[], |p| p.arrays().0)
}

/// The error of the pivot at `index` in the order of elimination.
fn not_positive(order: &[u32], index: usize) -> FactorError {
    FactorError::NotPositiveDefinite {
        equation: order.get(index).map_or(index, |e| *e as usize),
    }
}

/// Solves A x = b in place.
pub(in crate::solver::linear) fn solve<T: RealField>(
    symbolic: &sparse::SymbolicCholesky<u32>,
    values: &[T],
    x: &mut [T],
) {
    let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<T>(1, Par::Seq));
    let rows = x.len();
    sparse::LltRef::new(symbolic, values).solve_in_place_with_conj(
        Conj::No,
        MatMut::from_column_major_slice_mut(x, rows, 1),
        Par::Seq,
        MemStack::new(&mut memory),
    );
}
