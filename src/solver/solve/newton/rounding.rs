//! What rounding leaves of a balance.
//!
//! Forces of stiff bodies that move along with soft ones are differences of what is many times as large: of stiffness
//! times displacement, and of penalty times the displacement of both sides. What is left of their digits bounds how well
//! an increment can be in balance, and whether a change of a contact node means anything.

use crate::solver::linear::krylov::norm;
use crate::solver::linear::sparse::SymmetricMatrix;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::newton::progress::Progress;
use crate::solver::solve::params::{MOST_ROUNDING, STALLED_DECREASE};
use crate::solver::solve::rows::contact_row::ContactRow;

/// What rounding leaves undecided of the relative displacement of each row.
pub fn closures(model: &Model, point: &Point) -> Vec<f64> {
    let u = model.kept_displacement(&point.x, point.step, point.time);
    let of_row = |row: &ContactRow| {
        let terms = row.row.terms.iter();
        let sizes = terms.map(|(node, coefficient)| {
            let u = &u[*node as usize];
            (0..3).map(|i| (coefficient[i] * u[i]).abs()).sum::<f64>()
        });
        f64::EPSILON * (row.row.gap.abs() + sizes.sum::<f64>())
    };
    model.rows.iter().map(of_row).collect()
}

/// Norm of the forces that rounding may leave in the balance at `point`: that of the sizes of all that is summed there, in
/// units of the last digit.
pub fn rounding_forces(
    model: &Model,
    point: &Point,
    external: &[f64],
    evaluation: &Evaluation,
) -> f64 {
    let sizes = |values: &[f64]| values.iter().map(|v| v.abs()).collect::<Vec<f64>>();
    let stiffness = SymmetricMatrix {
        values: sizes(&model.stiffness.values),
    };
    let mut internal = vec![0.0; model.dofs.len()];
    (model.pattern).multiply(&stiffness, &sizes(&point.x), &mut internal);
    let mut nodal = vec![[0.0; 3]; model.scene.mesh.points.len()];
    let rows = model.rows.iter().zip(&evaluation.contact);
    for ((row, answer), closure) in rows.zip(closures(model, point)) {
        // The tangent is that of the traction, and so are the digits that it leaves.
        let steepest = (answer.tangent.iter().flatten()).fold(0.0f64, |most, k| most.max(k.abs()));
        let carried = norm(&answer.traction);
        let force = row.row.area * (carried + steepest * closure / f64::EPSILON);
        for (node, coefficient) in &row.row.terms {
            let nodal = &mut nodal[*node as usize];
            (nodal.iter_mut().zip(coefficient)).for_each(|(n, c)| *n += c.abs() * force);
        }
    }
    let mut all = sizes(&model.dofs.gather(&nodal));
    for ((all, external), internal) in all.iter_mut().zip(external).zip(&internal) {
        *all += external.abs() + internal;
    }
    f64::EPSILON * norm(&all)
}

/// Has the residual ceased to fall, where it is so small that it may be what rounding leaves?
pub fn has_stalled(residual: f64, progress: &Progress) -> bool {
    let before = progress.residuals.last();
    residual <= MOST_ROUNDING && before.is_some_and(|before| residual > STALLED_DECREASE * before)
}
