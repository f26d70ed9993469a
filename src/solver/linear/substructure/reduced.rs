//! A matrix with its inner unknowns eliminated: the Schur complement, reduction and recovery of vectors.

use super::condensation::Condensation;
use crate::solver::linear::cholesky::{Eliminated, FactorError, Tree, Triangles, eliminate};
use crate::solver::linear::pages::Pages;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};

/// A matrix with its inner unknowns eliminated.
pub struct Substructure {
    condensation: Condensation,
    tree: Tree,
    values: Pages<f64>,
}

impl Condensation {
    /// Eliminates the inner unknowns of `matrix`; also S, the lower triangle, column by column.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the inner block is not positive definite.
    pub fn eliminate(
        self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
    ) -> Result<(Substructure, Vec<f64>), FactorError> {
        let order = (&*self.order, self.eliminated);
        let Eliminated {
            tree,
            values,
            complement,
        } = eliminate(self.supernodal(), order, (pattern, matrix))?;
        let substructure = Substructure {
            condensation: self,
            tree,
            values,
        };
        Ok((substructure, complement))
    }
}

impl Substructure {
    /// What is kept, and in which order the rest was eliminated.
    pub fn condensation(&self) -> &Condensation {
        &self.condensation
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.values.len()
    }

    /// Eliminates in place: inner entries become L_II⁻¹ f_I, kept ones g.
    pub fn reduce(&self, f: &mut [f64]) {
        self.in_order(f, |triangles, x| triangles.reduce(x));
    }

    /// Undoes [`Self::reduce`] once the kept entries hold x_B: inner entries become x_I.
    pub fn recover(&self, f: &mut [f64]) {
        self.in_order(f, |triangles, x| triangles.recover(x));
    }

    /// Does `work` on the entries in the order of elimination.
    fn in_order(&self, f: &mut [f64], work: impl Fn(&Triangles<f64>, &mut [f64])) {
        let order = &self.condensation.order;
        let triangles = Triangles {
            symbolic: self.condensation.supernodal(),
            tree: &self.tree,
            values: &self.values,
            threads: rayon::current_num_threads(),
        };
        let mut x: Vec<f64> = order.iter().map(|e| f[*e as usize]).collect();
        work(&triangles, &mut x);
        for (equation, value) in order.iter().zip(x) {
            f[*equation as usize] = value;
        }
    }
}
