//! The structure of a factor, before any number.

use super::error::FactorError;
use crate::solver::linear::sparse::Pattern;
use faer::Side;
use faer::perm::PermRef;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::cholesky as sparse;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;

/// Structure of the factor of a lower triangle, the equations of which are eliminated in `order`.
pub(in crate::solver::linear) fn analyse(
    structure: SymbolicSparseColMatRef<u32>,
    order: &[u32],
    params: sparse::CholeskySymbolicParams,
) -> Result<sparse::SymbolicCholesky<u32>, FactorError> {
    let mut inverse = vec![0u32; order.len()];
    for (k, equation) in order.iter().enumerate() {
        inverse[*equation as usize] = k as u32;
    }
    let order = PermRef::new_checked(order, &inverse, order.len());
    let order = sparse::SymmetricOrdering::Custom(order);
    sparse::factorize_symbolic_cholesky(structure, Side::Lower, order, params)
        .map_err(|_| FactorError::Memory)
}

/// The lower triangle of a pattern as faer sees it.
pub(in crate::solver::linear) fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.len();
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.columns, None, &pattern.rows)
}

/// Multiplications that it takes to eliminate the columns before `end`.
pub(in crate::solver::linear) fn supernodal_work(
    nodes: &SymbolicSupernodalCholesky<u32>,
    end: usize,
) -> f64 {
    let columns = |s: usize| {
        let node = nodes.supernode(s);
        let width = nodes.supernode_end()[s] as usize - node.start();
        (node, width)
    };
    (0..nodes.n_supernodes())
        .map(columns)
        .filter(|(node, _)| node.start() < end)
        .map(|(node, width)| {
            let own = width.min(end - node.start());
            let below = (width - own + node.pattern().len()) as f64;
            let w = own as f64;
            // Column by column, half the square of what is left of it.
            0.5 * w * (below * below + below * w + w * w / 3.0)
        })
        .sum()
}
