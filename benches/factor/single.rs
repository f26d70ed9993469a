//! The same factorisation in single precision, by faer directly.

use crate::kit::Failure;
use brinell::solver::linear::sparse::{Pattern, SymmetricMatrix};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky as sparse;
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Par, Side};

/// The structure of a factor, by faer directly.
pub type Structure = sparse::SymbolicCholesky<u32>;

/// The structure of the factor under an order of the equations.
pub fn symbolic(pattern: &Pattern, order: &[u32]) -> Result<Structure, Failure> {
    let mut inverse = vec![0u32; order.len()];
    for (k, equation) in order.iter().enumerate() {
        inverse[*equation as usize] = k as u32;
    }
    let order = PermRef::new_checked(order, &inverse, order.len());
    let symbolic = sparse::factorize_symbolic_cholesky(
        structure(pattern),
        Side::Lower,
        sparse::SymmetricOrdering::Custom(order),
        Default::default(),
    );
    Ok(symbolic.map_err(|error| format!("{error:?}"))?)
}

/// A matrix and the storage of its factor.
pub struct Single<'a> {
    pattern: &'a Pattern,
    symbolic: Structure,
    values: Vec<f32>,
    factor: Vec<f32>,
}

impl<'a> Single<'a> {
    pub fn new(pattern: &'a Pattern, matrix: &SymmetricMatrix, symbolic: Structure) -> Self {
        Self {
            pattern,
            values: matrix.values.iter().map(|v| *v as f32).collect(),
            factor: vec![0.0; symbolic.len_val()],
            symbolic,
        }
    }

    pub fn factorise(&mut self, par: Par) -> Result<(), Failure> {
        let need = self
            .symbolic
            .factorize_numeric_llt_scratch::<f32>(par, Default::default());
        let mut memory = MemBuffer::try_new(need).map_err(|_| "no memory")?;
        self.symbolic
            .factorize_numeric_llt(
                &mut self.factor,
                SparseColMatRef::new(structure(self.pattern), &self.values),
                Side::Lower,
                LltRegularization::default(),
                par,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|error| format!("{error:?}"))?;
        Ok(())
    }
}

fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    let n = pattern.len();
    SymbolicSparseColMatRef::new_checked(n, n, &pattern.columns, None, &pattern.rows)
}
