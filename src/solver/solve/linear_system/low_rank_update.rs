//! A factor that has aged, brought up to date where contact has changed.
//!
//! From iteration to iteration the tangent changes by the contact rows that open, close, stick or slip, and each of
//! them changes it by rank three at most: A = A₀ + U D Uᵀ, with the rows' operators as columns of U and the changes of
//! their tangents in D. With Z = A₀⁻¹ U and G = Uᵀ Z (Sherman, Morrison and Woodbury; Hager 1989)
//! ```text
//! A⁻¹ b = y − Z (1 + D G)⁻¹ D Uᵀ y,        y = A₀⁻¹ b
//! ```
//! Columns of Z are found when their row changes for the first time, many at once, and kept as long as the factor is.
//! Rounding is no matter: what comes out is a preconditioner.

use crate::ground::geometry::add;
use crate::solver::contact::law::NodeResponse;
use crate::solver::fem::dofs::FIXED;
use crate::solver::linear::cholesky::Number;
use crate::solver::linear::preconditioner::Precision;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{KEPT_COLUMNS, NEW_COLUMNS_SHARE, UNKNOWNS_PER_TASK};
use crate::solver::solve::rows::contact_row::ContactRow;
use faer::linalg::solvers::PartialPivLu;
use faer::prelude::Solve;
use faer::{Mat, MatRef};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Tangent of a row by its local components, times its area.
type Tangent = [[f64; 3]; 3];

/// What a factor was made for, and what has been found of it since.
#[derive(Default)]
pub struct LowRankUpdate {
    made_for: Vec<Tangent>,
    /// Columns of Z, three a row.
    columns: BTreeMap<usize, [Column; 3]>,
    now: Option<LowRankChange>,
}

/// A column of Z, as precise as the factor that it was found with: each direction reads all of them.
enum Column {
    Single(Vec<f32>),
    Double(Vec<f64>),
}

impl Column {
    fn new(values: &[f64], precision: Precision) -> Self {
        match precision {
            Precision::Single => Self::Single(values.iter().map(|v| *v as f32).collect()),
            Precision::Double => Self::Double(values.to_vec()),
        }
    }

    fn at(&self, equation: usize) -> f64 {
        match self {
            Self::Single(values) => f64::from(values[equation]),
            Self::Double(values) => values[equation],
        }
    }

    /// Takes `share` times the entries from `from` on off `x`.
    fn take_off(&self, x: &mut [f64], from: usize, share: f64) {
        match self {
            Self::Single(values) => take_off(x, &values[from..], share),
            Self::Double(values) => take_off(x, &values[from..], share),
        }
    }
}

fn take_off<T: Number>(x: &mut [f64], values: &[T], share: f64) {
    let pairs = x.iter_mut().zip(values);
    pairs.for_each(|(x, z)| *x -= share * z.widened());
}

/// The correction for the tangent of now.
struct LowRankChange {
    rows: Vec<usize>,
    changes: Vec<Tangent>,
    system: PartialPivLu<f64>,
}

fn row_tangent(row: &ContactRow, answer: &NodeResponse) -> Tangent {
    answer.tangent.map(|line| line.map(|v| v * row.row.area))
}

impl LowRankUpdate {
    /// A factor was made at `evaluation`.
    pub fn new(model: &Model, evaluation: &Evaluation) -> Self {
        let rows = model.rows.iter().zip(&evaluation.contact);
        Self {
            made_for: rows.map(|(row, answer)| row_tangent(row, answer)).collect(),
            ..Self::default()
        }
    }

    /// Gets ready for the tangent at `evaluation`; `solve` replaces the columns of a matrix, one after the other, by
    /// A₀⁻¹ times these, to the `precision` of the factor. `false` where a new factor is the better way.
    pub fn prepare(
        &mut self,
        model: &Model,
        evaluation: &Evaluation,
        (solve, precision): (impl FnOnce(&mut [f64], usize), Precision),
    ) -> bool {
        self.now = None;
        let rows = model.rows.iter().zip(&evaluation.contact).enumerate();
        let changed = rows.filter_map(|(index, (row, answer))| {
            let (now, then) = (row_tangent(row, answer), self.made_for.get(index)?);
            let change = [0, 1, 2].map(|i| [0, 1, 2].map(|j| now[i][j] - then[i][j]));
            (change != Tangent::default()).then_some((index, change))
        });
        let (rows, changes): (Vec<usize>, Vec<Tangent>) = changed.unzip();
        let unknowns = model.dofs.len();
        let unknown = |row: &&usize| !self.columns.contains_key(row);
        let new: Vec<usize> = rows.iter().filter(unknown).copied().collect();
        let kept = 3 * (self.columns.len() + new.len());
        let dear = 3 * new.len() > (NEW_COLUMNS_SHARE * unknowns as f64) as usize;
        if dear || kept > KEPT_COLUMNS || kept * unknowns > model.preconditioner.factor_entries() {
            return false;
        }
        if !new.is_empty() {
            let mut block = vec![0.0; 3 * new.len() * unknowns];
            let parts = block.chunks_mut(3 * unknowns);
            for (row, columns) in new.iter().zip(parts) {
                for (k, column) in columns.chunks_mut(unknowns).enumerate() {
                    let mut unit = [0.0; 3];
                    unit[k] = 1.0;
                    model.rows[*row].scatter(model, &unit, column);
                }
            }
            solve(&mut block, 3 * new.len());
            for (row, columns) in new.iter().zip(block.chunks(3 * unknowns)) {
                let column = |k: usize| {
                    let values = &columns[k * unknowns..(k + 1) * unknowns];
                    Column::new(values, precision)
                };
                self.columns.insert(*row, [0, 1, 2].map(column));
            }
        }
        self.now = Some(self.correction(model, rows, changes));
        true
    }

    /// 1 + D G of the rows that have changed.
    fn correction(&self, model: &Model, rows: Vec<usize>, changes: Vec<Tangent>) -> LowRankChange {
        let size = 3 * rows.len();
        let found: Vec<&Column> = rows.iter().flat_map(|row| &self.columns[row]).collect();
        let mut entries = vec![0.0; size * size];
        let columns = entries.par_chunks_mut(size.max(1)).zip(found).enumerate();
        columns.for_each(|(k, (column, found))| {
            let parts = column.chunks_exact_mut(3);
            for (part, (row, change)) in parts.zip(rows.iter().zip(&changes)) {
                let moved = model.rows[*row].gather(model, |equation| found.at(equation));
                for (entry, change) in part.iter_mut().zip(change) {
                    *entry = (0..3).map(|j| change[j] * moved[j]).sum();
                }
            }
            column[k] += 1.0;
        });
        let system = MatRef::from_column_major_slice(&entries, size, size);
        LowRankChange {
            system: system.partial_piv_lu(),
            rows,
            changes,
        }
    }

    /// From A₀⁻¹ b to about A⁻¹ b.
    pub fn correct(&self, model: &Model, x: &mut [f64]) {
        let Some(now) = self.now.as_ref().filter(|now| !now.rows.is_empty()) else {
            return;
        };
        let mut pulled = Mat::<f64>::zeros(3 * now.rows.len(), 1);
        for (a, (row, change)) in now.rows.iter().zip(&now.changes).enumerate() {
            let moved = model.rows[*row].gather(model, |equation| x[equation]);
            for i in 0..3 {
                pulled[(3 * a + i, 0)] = (0..3).map(|j| change[i][j] * moved[j]).sum();
            }
        }
        let forces = now.system.solve(&pulled);
        let columns = now.rows.iter().flat_map(|row| &self.columns[row]);
        let columns: Vec<_> = columns.zip(forces.col_as_slice(0)).collect();
        (x.par_chunks_mut(UNKNOWNS_PER_TASK).enumerate()).for_each(|(k, x)| {
            let from = k * UNKNOWNS_PER_TASK;
            for (column, force) in &columns {
                column.take_off(x, from, **force);
            }
        });
    }
}

impl ContactRow {
    /// Relative displacement in local components, of the unknowns `x`.
    fn gather(&self, model: &Model, x: impl Fn(usize) -> f64) -> [f64; 3] {
        let mut d = self.relative_of(|node, axis| match model.dofs.equations[node][axis] {
            FIXED => 0.0,
            equation => x(equation as usize),
        });
        for (equation, axis, share) in self.further(&model.dofs) {
            let mut moved = [0.0; 3];
            moved[axis] = share * x(equation as usize);
            d = add(d, self.local(moved));
        }
        d
    }

    /// Adds the forces on unknowns of a traction in local components, over the area.
    fn scatter(&self, model: &Model, local: &[f64; 3], y: &mut [f64]) {
        let force = self.global(local);
        for (node, coefficient) in &self.row.terms {
            let equations = model.dofs.equations[*node as usize];
            for axis in 0..3 {
                if equations[axis] != FIXED {
                    y[equations[axis] as usize] += coefficient[axis] * force[axis];
                }
            }
        }
        for (equation, axis, share) in self.further(&model.dofs) {
            y[equation as usize] += share * force[axis];
        }
    }
}
