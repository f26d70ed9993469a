//! Pressure, gap, slip and force of each contact node.

use crate::model::scene::{ContactPair, Scene};
use crate::model::state::ContactField;
use crate::solver::contact::facing::Sight;
use crate::solver::contact::mortar::Row;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::recovery::consistent::consistent_tractions;
use crate::solver::solve::recovery::gaps::see_gaps;

pub fn contact_fields(
    model: &Model,
    history: &History,
    (evaluation, sights): (&Evaluation, &[Vec<Sight>]),
    u: &[[f64; 3]],
) -> Vec<ContactField> {
    let scene = model.scene;
    let mut fields: Vec<ContactField> = scene
        .contacts
        .iter()
        .map(|pair| ContactField::open(carrier_nodes(scene, pair)))
        .collect();
    for (index, row) in model.rows.iter().enumerate() {
        let field = &mut fields[row.pair];
        let Ok(at) = field.nodes.binary_search(&row.row.node) else {
            continue;
        };
        let (answer, d) = (&evaluation.contact[index], &evaluation.relative[index]);
        let sign = scene.contacts[row.pair].carrier.sign();
        field.multiplier[at] = answer.traction[0];
        field.gap[at] = -d[0];
        field.slip[at] = history.slip[index];
        field.status[at] = answer.status as u8;
        field.area[at] = row.row.area;
        field.force[at] = row
            .global(&answer.traction)
            .map(|v| sign * v * row.row.area);
        field.acts_at[at] = acts_at(&scene.mesh.points, &row.row, &field.nodes);
    }
    // Rows that were left out are open; the pressure of a strip falls to zero at the first of them.
    for row in &model.spare {
        let field = &mut fields[row.pair];
        if let Ok(at) = field.nodes.binary_search(&row.row.node) {
            field.gap[at] = row.row.gap - row.relative(u)[0];
            field.area[at] = row.row.area;
        }
    }
    consistent_tractions(model, evaluation, &mut fields);
    for (field, sights) in fields.iter_mut().zip(sights) {
        see_gaps(field, sights, (&scene.mesh.points, u));
    }
    fields
}

/// The nodes that the field of a pair stands on.
pub fn carrier_nodes(scene: &Scene, pair: &ContactPair) -> Vec<u32> {
    let [carrier, _] = pair.carrier_first();
    let nodes = carrier.surface(&scene.mesh).map(|s| s.nodes());
    nodes.unwrap_or_default()
}

/// Where the force of a row acts: the mean of the positions that its closure is the difference of,
/// on the carrier, whose nodes are `nodes`, and opposite. The force on either surface is the row's
/// times the same coefficients, so that moments balance as forces do.
fn acts_at(points: &[[f64; 3]], row: &Row, nodes: &[u32]) -> [[f64; 3]; 2] {
    let mut sides = [[0.0; 3]; 2];
    let mut faces_something = false;
    for (node, coefficients) in &row.terms {
        let opposite = nodes.binary_search(node).is_err();
        faces_something |= opposite;
        let (side, sign) = if opposite { (1, -1.0) } else { (0, 1.0) };
        for (axis, c) in coefficients.iter().enumerate() {
            sides[side][axis] += sign * c * points[*node as usize][axis];
        }
    }
    // A rigid plane has no nodes.
    if !faces_something {
        sides[1] = sides[0];
    }
    sides
}
