//! Static condensation: a sparse matrix seen from a few kept unknowns.
//!
//! With the inner unknowns I eliminated and B kept, K x = f becomes S x_B = g with
//! S = K_BB − K_BI K_II⁻¹ K_IB and g = f_B − K_BI K_II⁻¹ f_I (Guyan 1965; Przemieniecki 1968).
//! A supernodal Cholesky factor with B last gives all of it: the trailing block L_BB is a factor
//! of S, and half a triangular solve is the reduction of f.

use super::cholesky::{FactorError, analyse, numeric, structure, supernodal_work};
use super::ordering;
use super::pages::Pages;
use super::sparse::{Pattern, SymmetricMatrix};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::{SupernodalLltRef, SymbolicSupernodalCholesky};
use faer::sparse::linalg::cholesky::{self as sparse, SymbolicCholesky, SymbolicCholeskyRaw};
use faer::{Accum, Mat, Par};
use std::sync::OnceLock;

/// Order and structure of the factor, before any number.
pub struct Condensation {
    inner: SymbolicCholesky<u32>,
    /// Equations in the order of elimination, the kept ones last and ascending.
    order: Vec<u32>,
    eliminated: usize,
}

/// A matrix with its inner unknowns eliminated.
pub struct Substructure {
    condensation: Condensation,
    values: Pages<f64>,
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

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.inner.len_val()
    }

    /// Number of equations kept.
    pub fn kept(&self) -> usize {
        self.order.len() - self.eliminated
    }

    /// The kept equations, ascending.
    pub fn kept_equations(&self) -> &[u32] {
        &self.order[self.eliminated..]
    }

    fn supernodal(&self) -> &SymbolicSupernodalCholesky<u32> {
        match self.inner.raw() {
            SymbolicCholeskyRaw::Supernodal(s) => s,
            SymbolicCholeskyRaw::Simplicial(_) => unreachable!("supernodal was asked for"),
        }
    }

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::linear::cholesky::Symbolic;
    use crate::solver::linear::ordering::Block;

    /// A chain of vertices with two equations each, tied down at one end.
    fn chain(n: u32) -> (Pattern, SymmetricMatrix) {
        let cliques: Vec<Vec<u32>> = (0..n - 1).map(|i| vec![i, i + 1]).collect();
        let starts = (0..=n).map(|i| 2 * i).collect();
        let pattern = Pattern::new(starts, cliques.iter().map(Vec::as_slice));
        let mut m = pattern.zeros();
        for c in &cliques {
            let equations = [2 * c[0], 2 * c[0] + 1, 2 * c[1], 2 * c[1] + 1];
            let k = [
                [2.0, 0.5, -2.0, -0.5],
                [0.5, 3.0, -0.5, -3.0],
                [-2.0, -0.5, 2.0, 0.5],
                [-0.5, -3.0, 0.5, 3.0],
            ];
            pattern.add_block(&mut m, &equations, |i, j| k[i][j]);
        }
        pattern.add_block(&mut m, &[0, 1], |i, j| if i == j { 1.0 } else { 0.0 });
        (pattern, m)
    }

    #[test]
    fn the_condensed_system_has_the_answer_of_the_whole() {
        let (pattern, matrix) = chain(40);
        let f: Vec<f64> = (0..80).map(|i| f64::from(i).sin()).collect();
        let mut exact = f.clone();
        let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..40)]).unwrap();
        let factor = symbolic.factorise::<f64>(&pattern, &matrix, None).unwrap();
        symbolic.solve(&factor, &mut exact);

        let mut kept = vec![false; 40];
        for vertex in [3, 17, 39] {
            kept[vertex] = true;
        }
        let condensation = Condensation::new(&pattern, &kept).unwrap();
        assert_eq!(condensation.kept_equations(), [6, 7, 34, 35, 78, 79]);
        let (part, schur) = condensation.eliminate(&pattern, matrix).unwrap();
        let mut x = f;
        part.reduce(&mut x);
        let kept = part.condensation().kept_equations().to_vec();
        // S x_B = g with the exact x_B.
        for (i, row) in kept.iter().enumerate() {
            let product: f64 = kept
                .iter()
                .enumerate()
                .map(|(j, c)| schur[(i.max(j), i.min(j))] * exact[*c as usize])
                .sum();
            assert!((product - x[*row as usize]).abs() < 1e-11);
        }
        for equation in &kept {
            x[*equation as usize] = exact[*equation as usize];
        }
        part.recover(&mut x);
        assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-11));
    }
}
