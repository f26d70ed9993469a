//! A factor that has aged, brought up to date where contact has changed.
//!
//! From iteration to iteration the tangent changes by the contact rows that open, close, stick or slip, and each of
//! them changes it by rank three at most: A = A₀ + U D Uᵀ, with the rows' operators as columns of U and the changes of
//! their tangents in D. With the factor A₀ = L Lᵀ, W = L⁻¹ U and G = Wᵀ W (Sherman, Morrison and Woodbury; Hager 1989)
//! ```text
//! A⁻¹ = L⁻ᵀ (1 − W (1 + D G)⁻¹ D Wᵀ) L⁻¹
//! ```
//! Columns of W are found when their row changes for the first time, many at once, and kept as long as the factor is. A row
//! is about a few nodes, and what L⁻¹ makes of them reaches a small part of the unknowns only.
//! Rounding is no matter: what comes out is a preconditioner.

use crate::solver::contact::law::NodeResponse;
use crate::solver::fem::dofs::FIXED;
use crate::solver::linear::cholesky::{ReachedColumns, SparseColumn};
use crate::solver::linear::preconditioner::Prepared;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{KEPT_COLUMNS, NEW_COLUMNS_WORK};
use crate::solver::solve::rows::contact_row::ContactRow;
use faer::linalg::solvers::PartialPivLu;
use faer::prelude::Solve;
use faer::{Mat, MatRef};
use rayon::prelude::*;

/// Three by three, in the local components of two rows: of one row its tangent, times its area.
type Block = [[f64; 3]; 3];

/// What a factor was made for, and what has been found of it since.
#[derive(Default)]
pub struct LowRankUpdate {
    made_for: Vec<Block>,
    /// Where each row is among those whose columns were found.
    place: Vec<Option<usize>>,
    /// Columns of W, three a row.
    columns: Vec<ReachedColumns>,
    /// Lower triangle of G for all of them, block by block.
    products: Vec<Vec<Block>>,
    now: Option<LowRankChange>,
}

/// The correction for the tangent of now.
struct LowRankChange {
    /// Places of the rows that have changed,
    rows: Vec<usize>,
    /// and by how much.
    changes: Vec<Block>,
    system: PartialPivLu<f64>,
}

fn row_tangent(row: &ContactRow, answer: &NodeResponse) -> Block {
    answer.tangent.map(|line| line.map(|v| v * row.row.area))
}

impl LowRankUpdate {
    /// A factor was made at `evaluation`.
    pub fn new(model: &Model, evaluation: &Evaluation) -> Self {
        let rows = model.rows.iter().zip(&evaluation.contact);
        Self {
            made_for: rows.map(|(row, answer)| row_tangent(row, answer)).collect(),
            place: vec![None; model.rows.len()],
            ..Self::default()
        }
    }

    /// Gets ready for the tangent at `evaluation`, with the `factor` that has aged. `false` where a new factor is the
    /// better way.
    pub fn prepare(&mut self, model: &Model, evaluation: &Evaluation, factor: &Prepared) -> bool {
        self.now = None;
        let rows = model.rows.iter().zip(&evaluation.contact).enumerate();
        let changed = rows.filter_map(|(index, (row, answer))| {
            let (now, then) = (row_tangent(row, answer), self.made_for.get(index)?);
            let change = [0, 1, 2].map(|i| [0, 1, 2].map(|j| now[i][j] - then[i][j]));
            (change != Block::default()).then_some((index, change))
        });
        let (rows, changes): (Vec<usize>, Vec<Block>) = changed.unzip();
        let unknown = |row: &&usize| self.place[**row].is_none();
        let new: Vec<usize> = rows.iter().filter(unknown).copied().collect();
        if 3 * (self.columns.len() + new.len()) > KEPT_COLUMNS || !self.find(model, &new, factor) {
            return false;
        }
        let places = rows.iter().filter_map(|row| self.place[*row]).collect();
        self.now = Some(self.change(places, changes));
        true
    }

    /// Finds the columns of the `new` rows, if that takes less than a new factor.
    fn find(&mut self, model: &Model, new: &[usize], factor: &Prepared) -> bool {
        if new.is_empty() {
            return true;
        }
        let loads: Vec<_> = (new.iter().map(|row| model.rows[*row].unit_loads(model))).collect();
        let found = (model.preconditioner).reach(factor, &loads, NEW_COLUMNS_WORK);
        let Some(found) = found else {
            return false;
        };
        let known = self.columns.len();
        self.columns.extend(found);
        let columns = &self.columns;
        let lines = (known..columns.len()).into_par_iter();
        let lines = lines.map(|a| (0..=a).map(|b| columns[a].products(&columns[b])).collect());
        self.products.par_extend(lines);
        for (row, place) in new.iter().zip(known..) {
            self.place[*row] = Some(place);
        }
        true
    }

    /// 1 + D G of these `rows`, by their places, that have changed.
    fn change(&self, rows: Vec<usize>, changes: Vec<Block>) -> LowRankChange {
        let size = 3 * rows.len();
        let mut entries = Mat::<f64>::identity(size, size);
        for (a, (row, change)) in rows.iter().zip(&changes).enumerate() {
            for (b, other) in rows.iter().enumerate() {
                let (high, low) = (row.max(other), row.min(other));
                let product = self.products[*high][*low];
                for i in 0..3 {
                    for j in 0..3 {
                        // Block (row, other) of G is the transpose of block (other, row).
                        let g = |k: usize| {
                            if row == high {
                                product[k][j]
                            } else {
                                product[j][k]
                            }
                        };
                        entries[(3 * a + i, 3 * b + j)] +=
                            (0..3).map(|k| change[i][k] * g(k)).sum::<f64>();
                    }
                }
            }
        }
        LowRankChange {
            system: entries.partial_piv_lu(),
            rows,
            changes,
        }
    }

    /// Multiplies `x`, between the two triangles of the factor, by 1 − W (1 + D G)⁻¹ D Wᵀ.
    pub fn correct(&self, x: &mut [f64]) {
        let Some(now) = self.now.as_ref().filter(|now| !now.rows.is_empty()) else {
            return;
        };
        let pulled = now.rows.par_iter().zip(&now.changes).map(|(row, change)| {
            let moved = self.columns[*row].pull(x);
            change.map(|line| (0..3).map(|j| line[j] * moved[j]).sum::<f64>())
        });
        let pulled: Vec<[f64; 3]> = pulled.collect();
        let pulled = MatRef::from_column_major_slice(pulled.as_flattened(), 3 * pulled.len(), 1);
        let forces = now.system.solve(&pulled);
        let (forces, _) = forces.col_as_slice(0).as_chunks();
        for (row, force) in now.rows.iter().zip(forces) {
            self.columns[*row].take_off(*force, x);
        }
    }
}

impl ContactRow {
    /// Forces on the unknowns of a traction of one over the area, in each local component.
    fn unit_loads(&self, model: &Model) -> [SparseColumn; 3] {
        [0, 1, 2].map(|k| {
            let mut unit = [0.0; 3];
            unit[k] = 1.0;
            let force = self.global(&unit);
            let terms = self.row.terms.iter().flat_map(|(node, coefficient)| {
                let equations = model.dofs.equations[*node as usize];
                let free = move |axis: &usize| equations[*axis] != FIXED;
                let load = move |axis| (equations[axis] as usize, coefficient[axis] * force[axis]);
                (0..3).filter(free).map(load)
            });
            let further = self.further(&model.dofs).into_iter();
            let further =
                further.map(|(equation, axis, share)| (equation as usize, share * force[axis]));
            terms.chain(further).collect()
        })
    }
}
