//! An accepted solution in the terms of the scene.

use super::consistent::consistent_tractions;
use super::evaluate::Evaluation;
use super::history::{History, Plastic, points};
use super::model::Model;
use super::newton::Point;
use crate::model::material::j2::PlasticPoint;
use crate::model::scene::PlaneMotion;
use crate::model::state::{ContactField, PlaneField, State};
use crate::solver::contact::facing::Sight;
use crate::solver::contact::mortar::Row;
use crate::solver::solve::params::RIM_OVERLAP;
use rayon::prelude::*;

/// The accepted state in the terms of the scene.
pub fn recovered_state(
    model: &Model,
    history: &History,
    point: &Point,
    (evaluation, sights): (&Evaluation, &[Vec<Sight>]),
) -> State {
    let displacement = model.displacement(point, &history.settled);
    let plastic = history.all_plastic(model);
    let (stress, peeq) = stresses(model, &plastic, &displacement);
    State {
        step: point.step,
        time: point.time,
        contacts: contact_fields(model, history, (evaluation, sights), &displacement),
        planes: plane_fields(model, &plastic, point, &displacement),
        displacement,
        stress,
        peeq,
        energy: None,
    }
}

/// Stresses and equivalent plastic strains at all integration points.
pub fn stresses(
    model: &Model,
    plastic: &Plastic,
    u: &[[f64; 3]],
) -> (Vec<[[f64; 6]; 8]>, Vec<[f64; 8]>) {
    let mesh = &model.scene.mesh;
    let stress_of = |element: usize, points: &[PlasticPoint; 8]| {
        let local = mesh.hexes[element].map(|n| u[n as usize]);
        let elastic = &model.elastic[mesh.body_of(element)];
        let shape = model.element(element as u32);
        shape.stress(elastic, &local, points)
    };
    let elements = (0..mesh.hexes.len()).into_par_iter();
    if plastic.is_empty() {
        // Nothing has yielded: no plastic strain is put out.
        let virgin = [PlasticPoint::default(); 8];
        return (
            elements.map(|e| stress_of(e, &virgin)).collect(),
            Vec::new(),
        );
    }
    elements
        .map(|element| {
            let points = points(plastic, element as u32);
            (stress_of(element, &points), points.map(|p| p.peeq))
        })
        .unzip()
}

fn contact_fields(
    model: &Model,
    history: &History,
    (evaluation, sights): (&Evaluation, &[Vec<Sight>]),
    u: &[[f64; 3]],
) -> Vec<ContactField> {
    let scene = model.scene;
    let mut fields: Vec<ContactField> = scene
        .contacts
        .iter()
        .map(|pair| {
            let [carrier, _] = pair.carrier_first();
            let nodes = carrier.surface(&scene.mesh).map(|s| s.nodes());
            ContactField::open(nodes.unwrap_or_default())
        })
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
        see_gaps(field, sights, u);
    }
    fields
}

/// What is seen of a pair without any contact row: the gaps of nodes that no row exists for, and the
/// deepest overlap of the two sides.
fn see_gaps(field: &mut ContactField, sights: &[Sight], u: &[[f64; 3]]) {
    let gaps: Vec<f64> = sights.iter().map(|sight| sight.gap_at(u)).collect();
    let place = |node: u32| field.nodes.binary_search(&node).ok();
    let mut seen = vec![None; field.nodes.len()];
    for (sight, gap) in sights.iter().zip(&gaps) {
        if let Some(at) = sight.node.and_then(place) {
            seen[at] = Some(*gap);
        }
    }
    // Where meshes do not match, flat facets on either side bend differently: by how much the middle of
    // a facet is off the mean of its corners.
    let mut bend = vec![0.0f64; field.nodes.len()];
    for (sight, gap) in sights.iter().zip(&gaps).filter(|(s, _)| s.is_middle()) {
        let corners = sight
            .carrier
            .0
            .map(|node| place(node).and_then(|at| seen[at]));
        if let [Some(a), Some(b), Some(c), Some(d)] = corners {
            let off = (gap - 0.25 * (a + b + c + d)).abs();
            let nodes = sight.carrier.0.into_iter().filter_map(place);
            nodes.for_each(|at| bend[at] = bend[at].max(off));
        }
    }
    let mut sagitta = vec![0.0f64; field.nodes.len()];
    for (sight, gap) in sights.iter().zip(&gaps) {
        let nodes = || sight.carrier.0.into_iter().filter_map(place);
        nodes().for_each(|at| sagitta[at] = sagitta[at].max(sight.sagitta));
        let bend = nodes().map(|at| bend[at]).fold(0.0, f64::max);
        let explained = RIM_OVERLAP * (sight.sagitta + bend);
        field.penetration = field.penetration.max(-gap);
        field.unexplained = field.unexplained.max(-gap - explained);
    }
    field.sagitta = sagitta;
    for (gap, seen) in field.gap.iter_mut().zip(seen) {
        if gap.is_infinite() {
            *gap = seen.unwrap_or(f64::INFINITY);
        }
    }
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

fn plane_fields(
    model: &Model,
    plastic: &Plastic,
    point: &Point,
    u: &[[f64; 3]],
) -> Vec<PlaneField> {
    let planes = model.scene.rigid_planes.iter().zip(&model.all.planes);
    planes
        .map(|(plane, equations)| {
            let node = model
                .scene
                .mesh
                .surface(&plane.surface)
                .and_then(|s| s.faces.first());
            let travel = node.map_or([0.0; 3], |f| u[f.nodes[0] as usize]);
            let factor = model.scene.factor(&plane.name, point.step, point.time);
            let held = plane.motion.map(|m| matches!(m, PlaneMotion::Held(_)));
            let reaction = model.reaction(plastic, u, &plane.surface, held);
            let force = std::array::from_fn(|axis| match (plane.motion[axis], equations[axis]) {
                (PlaneMotion::Driven(load), Some(_)) => factor * load,
                _ => reaction[axis],
            });
            PlaneField { travel, force }
        })
        .collect()
}
