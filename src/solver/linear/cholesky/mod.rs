//! Sparse Cholesky factor on a fixed pattern and order: faer's structure and kernels, and its
//! numeric factor on one thread; on more `subtrees` shares the work out.

mod entries;
mod number;
mod subtrees;
mod tree;

use super::ordering::{self, Block};
use super::pages::Pages;
use super::sparse::{Pattern, SymmetricMatrix};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{self as sparse, SymbolicCholeskyRaw};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::traits::RealField;
use faer::{Conj, MatMut, Par, Side};
pub use number::Number;
use rayon::prelude::*;
use std::sync::OnceLock;
use subtrees::{Pivot, Plan};

/// Symbolic work that is done once a pattern: order and structure of the factor.
pub struct Symbolic {
    inner: sparse::SymbolicCholesky<u32>,
    /// Made at the first factorisation on several threads.
    plan: OnceLock<Plan>,
}

/// A numeric factor, of the matrix scaled to a diagonal of one.
pub struct Factor<T> {
    values: Pages<T>,
    /// One over the root of the diagonal.
    scale: Vec<f64>,
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

    /// Solves A x = b in place.
    pub fn solve<T: Number>(&self, factor: &Factor<T>, x: &mut [f64]) {
        self.solve_many(factor, x, 1);
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

/// Multiplications that it takes to eliminate the columns before `end`.
pub(super) fn supernodal_work(nodes: &SymbolicSupernodalCholesky<u32>, end: usize) -> f64 {
    let columns = |s: usize| {
        let node = nodes.supernode(s);
        let width = nodes.supernode_end()[s] as usize - node.start();
        (node, width)
    };
    (0..nodes.n_supernodes())
        .map(columns)
        .filter(|(node, _)| node.start() < end)
        .map(|(node, width)| {
            let (below, w) = (node.pattern().len() as f64, width as f64);
            // Column by column, half the square of what is left of it.
            0.5 * w * (below * below + below * w + w * w / 3.0)
        })
        .sum()
}

/// Structure of the factor of a lower triangle, the equations of which are eliminated in `order`.
pub(super) fn analyse(
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

/// Solves A X = B in place, for `count` columns.
pub(super) fn solve<T: RealField>(
    symbolic: &sparse::SymbolicCholesky<u32>,
    values: &[T],
    x: &mut [T],
    count: usize,
) {
    let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<T>(count, Par::Seq));
    let rows = x.len() / count;
    sparse::LltRef::new(symbolic, values).solve_in_place_with_conj(
        Conj::No,
        MatMut::from_column_major_slice_mut(x, rows, count),
        Par::Seq,
        MemStack::new(&mut memory),
    );
}

pub(super) fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.len();
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.columns, None, &pattern.rows)
}

/// One over the root of each entry of the diagonal.
fn scale(pattern: &Pattern, matrix: &SymmetricMatrix) -> Result<Vec<f64>, FactorError> {
    let diagonal = pattern.diagonal(matrix).into_iter().enumerate();
    diagonal
        .map(|(equation, d)| match d > 0.0 {
            true => Ok(1.0 / d.sqrt()),
            false => Err(FactorError::NotPositiveDefinite { equation }),
        })
        .collect()
}

/// The entries of `matrix`, scaled from both sides.
fn scaled<T: Number>(pattern: &Pattern, matrix: &SymmetricMatrix, scale: &[f64]) -> Vec<T> {
    let mut entries = Vec::with_capacity(matrix.values.len());
    for (ends, column) in pattern.columns.windows(2).zip(scale) {
        let range = ends[0] as usize..ends[1] as usize;
        let rows = pattern.rows[range.clone()].iter();
        let values = rows.zip(&matrix.values[range]);
        entries.extend(values.map(|(row, v)| T::rounded(v * column * scale[*row as usize])));
    }
    entries
}

/// Factors the matrix of these `entries` into `values`, on all threads of the pool; the `plan` is made where it is
/// missing.
pub(super) fn numeric<T: Number>(
    symbolic: &sparse::SymbolicCholesky<u32>,
    plan: &OnceLock<Plan>,
    pattern: &Pattern,
    entries: &[T],
    values: &mut [T],
) -> Result<(), FactorError> {
    let threads = rayon::current_num_threads();
    if let (SymbolicCholeskyRaw::Supernodal(nodes), 2..) = (symbolic.raw(), threads) {
        let order = order(symbolic);
        let plan = plan.get_or_init(|| Plan::new(nodes, pattern, order));
        return (plan.factorise(nodes, entries, values)).map_err(|Pivot(k)| not_positive(order, k));
    }
    numeric_alone(symbolic, structure(pattern), entries, values)
}

/// Factors a lower triangle into `values` on one thread.
pub(super) fn numeric_alone<T: RealField>(
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
fn order(symbolic: &sparse::SymbolicCholesky<u32>) -> &[u32] {
    symbolic.perm().map_or(&[], |p| p.arrays().0)
}

/// The error of the pivot at `index` in the order of elimination.
fn not_positive(order: &[u32], index: usize) -> FactorError {
    FactorError::NotPositiveDefinite {
        equation: order.get(index).map_or(index, |e| *e as usize),
    }
}

#[cfg(test)]
pub(super) mod tests {
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
        let factor = symbolic.factorise::<f64>(&pattern, &m, None).unwrap();
        symbolic.solve(&factor, &mut b);
        assert!(b.iter().zip(&x).all(|(b, x)| (b - x).abs() < 1e-12));
    }

    /// A plate of springs between neighbours, `spring` being the entries of each: a factor of many supernodes.
    pub fn plate(n: u32, spring: impl Fn(usize, usize) -> f64) -> (Pattern, SymmetricMatrix) {
        let at = |i: u32, j: u32| i + n * j;
        let right = (0..n).flat_map(|j| (0..n - 1).map(move |i| [at(i, j), at(i + 1, j)]));
        let up = (0..n - 1).flat_map(|j| (0..n).map(move |i| [at(i, j), at(i, j + 1)]));
        let springs: Vec<[u32; 2]> = right.chain(up).collect();
        let starts = (0..=n * n).map(|v| 3 * v).collect();
        let pattern = Pattern::new(starts, springs.iter().map(|s| s.as_slice()));
        let mut m = pattern.zeros();
        for [a, b] in springs {
            let equations: Vec<u32> = (3 * a..3 * a + 3).chain(3 * b..3 * b + 3).collect();
            pattern.add_block(&mut m, &equations, &spring);
        }
        (pattern, m)
    }

    /// Held everywhere a little.
    fn held(i: usize, j: usize) -> f64 {
        match (i == j, i % 3 == j % 3) {
            (true, _) => 2.0,
            (false, true) => -1.0,
            _ => 0.1,
        }
    }

    fn threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(count)
            .build()
            .unwrap();
        pool.install(work)
    }

    #[test]
    fn threads_do_not_change_the_factor() {
        let (pattern, m) = plate(60, held);
        let n = pattern.len();
        let x: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let mut b = vec![0.0; n];
        pattern.multiply(&m, &x, &mut b);
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
        let factors = [1, 2, 3].map(|count| {
            threads(count, || {
                symbolic.factorise::<f64>(&pattern, &m, None).unwrap()
            })
        });
        for factor in &factors {
            let mut solved = b.clone();
            symbolic.solve(factor, &mut solved);
            assert!(solved.iter().zip(&x).all(|(s, x)| (s - x).abs() < 1e-11));
            let pairs = factor.values.iter().zip(factors[0].values.iter());
            assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12));
        }
    }

    #[test]
    fn single_precision_solves_to_its_own_rounding() {
        let (pattern, mut m) = plate(60, held);
        // Far beyond what single precision can tell from nothing.
        m.values.iter_mut().for_each(|v| *v *= 1e60);
        let x: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
        let mut b = vec![0.0; pattern.len()];
        pattern.multiply(&m, &x, &mut b);
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
        let factor = symbolic.factorise::<f32>(&pattern, &m, None).unwrap();
        symbolic.solve(&factor, &mut b);
        let error = b.iter().zip(&x).map(|(b, x)| (b - x).abs());
        let error = error.fold(0.0, f64::max);
        assert!((1e-12..1e-4).contains(&error), "{error:.1e}");
    }

    #[test]
    fn a_pivot_that_is_not_positive_is_named_on_any_number_of_threads() {
        let (pattern, mut m) = plate(60, held);
        m.values[pattern.columns[5000] as usize] = -1.0;
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
        for count in [1, 2] {
            let result = threads(count, || {
                symbolic.factorise::<f64>(&pattern, &m, None).map(|_| ())
            });
            assert_eq!(
                result,
                Err(FactorError::NotPositiveDefinite { equation: 5000 })
            );
        }
    }
}
