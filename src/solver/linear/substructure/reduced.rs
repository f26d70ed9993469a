//! A matrix with its inner unknowns eliminated: the Schur complement, reduction and recovery of vectors.

use super::condensation::Condensation;
use crate::solver::linear::cholesky::{FactorError, numeric};
use crate::solver::linear::pages::Pages;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::{Accum, Mat, Par};
use std::sync::OnceLock;

/// A matrix with its inner unknowns eliminated.
pub struct Substructure {
    condensation: Condensation,
    values: Pages<f64>,
}

impl Condensation {
    /// Eliminates the inner unknowns of `matrix`; also the dense S, lower triangle.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the inner block is not positive definite.
    pub fn eliminate(
        self,
        pattern: &Pattern,
        mut matrix: SymmetricMatrix,
    ) -> Result<(Substructure, Mat<f64>), FactorError> {
        // S of a body that floats is singular: twice the kept diagonal is factored instead, and
        // taken off again, which costs no digits.
        let mut added = Vec::with_capacity(self.kept());
        for equation in self.kept_equations() {
            let diagonal = &mut matrix.values[pattern.columns[*equation as usize] as usize];
            added.push(*diagonal);
            *diagonal *= 2.0;
        }
        let mut values = Pages::new(self.inner.len_val()).map_err(|_| FactorError::Memory)?;
        numeric(
            &self.inner,
            &OnceLock::new(),
            pattern,
            &matrix.values,
            &mut values,
        )?;
        let whole = Substructure {
            condensation: self,
            values,
        };
        let schur = whole.schur(&added);
        Ok((whole, schur))
    }
}

impl Substructure {
    /// What is kept, and in which order the rest was eliminated.
    pub fn condensation(&self) -> &Condensation {
        &self.condensation
    }

    /// L_BB L_BBᵀ less the diagonal that was added.
    fn schur(&self, added: &[f64]) -> Mat<f64> {
        let first = self.condensation.eliminated;
        let kept = self.condensation.kept();
        let mut factor = Mat::<f64>::zeros(kept, kept);
        self.supernodes(|start, width, rows, block| {
            let height = width + rows.len();
            for j in first.saturating_sub(start)..width {
                let column = &block[j * height..(j + 1) * height];
                for i in j..width {
                    factor[(start + i - first, start + j - first)] = column[i];
                }
                for (row, value) in rows.iter().zip(&column[width..]) {
                    factor[(*row as usize - first, start + j - first)] = *value;
                }
            }
        });
        let mut schur = Mat::<f64>::zeros(kept, kept);
        faer::linalg::matmul::triangular::matmul(
            schur.as_mut(),
            faer::linalg::matmul::triangular::BlockStructure::TriangularLower,
            Accum::Replace,
            factor.as_ref(),
            faer::linalg::matmul::triangular::BlockStructure::TriangularLower,
            factor.transpose(),
            faer::linalg::matmul::triangular::BlockStructure::TriangularUpper,
            1.0,
            Par::Seq,
        );
        for (i, d) in added.iter().enumerate() {
            schur[(i, i)] -= d;
        }
        schur
    }

    /// Eliminates in place: inner entries become L_II⁻¹ f_I, kept ones g.
    pub fn reduce(&self, f: &mut [f64]) {
        let order = &self.condensation.order;
        let eliminated = self.condensation.eliminated;
        let mut x: Vec<f64> = order.iter().map(|e| f[*e as usize]).collect();
        let mut below = Vec::new();
        self.supernodes(|start, width, rows, block| {
            let height = width + rows.len();
            below.clear();
            below.resize(rows.len(), 0.0);
            for j in 0..width.min(eliminated.saturating_sub(start)) {
                let column = &block[j * height..(j + 1) * height];
                let value = x[start + j] / column[j];
                x[start + j] = value;
                let top = &mut x[start + j + 1..start + width];
                for (x, l) in top.iter_mut().zip(&column[j + 1..width]) {
                    *x -= l * value;
                }
                for (b, l) in below.iter_mut().zip(&column[width..]) {
                    *b += l * value;
                }
            }
            for (row, b) in rows.iter().zip(&below) {
                x[*row as usize] -= b;
            }
        });
        for (equation, value) in order.iter().zip(x) {
            f[*equation as usize] = value;
        }
    }

    /// Undoes [`Self::reduce`] once the kept entries hold x_B: inner entries become x_I.
    pub fn recover(&self, f: &mut [f64]) {
        let order = &self.condensation.order;
        let eliminated = self.condensation.eliminated;
        let mut x: Vec<f64> = order.iter().map(|e| f[*e as usize]).collect();
        let mut below = Vec::new();
        let nodes = self.condensation.supernodal();
        for s in (0..nodes.n_supernodes()).rev() {
            let (start, width, rows, block) = self.supernode(s);
            let height = width + rows.len();
            below.clear();
            below.extend(rows.iter().map(|r| x[*r as usize]));
            for j in (0..width.min(eliminated.saturating_sub(start))).rev() {
                let column = &block[j * height..(j + 1) * height];
                let top = &x[start + j + 1..start + width];
                let sum: f64 = top
                    .iter()
                    .zip(&column[j + 1..width])
                    .chain(below.iter().zip(&column[width..]))
                    .map(|(x, l)| x * l)
                    .sum();
                x[start + j] = (x[start + j] - sum) / column[j];
            }
        }
        for (equation, value) in order.iter().zip(x) {
            f[*equation as usize] = value;
        }
    }

    /// First position, columns, rows below them and values (column by column) of a supernode.
    fn supernode(&self, s: usize) -> (usize, usize, &[u32], &[f64]) {
        let nodes = self.condensation.supernodal();
        let node = SupernodalLltRef::<u32, f64>::new(nodes, &self.values).supernode(s);
        let columns = nodes.col_ptr_for_val();
        let block = &self.values[columns[s] as usize..columns[s + 1] as usize];
        (node.start(), node.val().ncols(), node.pattern(), block)
    }

    fn supernodes(&self, mut visit: impl FnMut(usize, usize, &[u32], &[f64])) {
        for s in 0..self.condensation.supernodal().n_supernodes() {
            let (start, width, rows, block) = self.supernode(s);
            visit(start, width, rows, block);
        }
    }
}
