//! What ties carry.
//!
//! A node that follows has no equation of its own: what loads, inner forces and contact leave over there goes through the
//! tie, to the nodes that it follows.

use crate::ground::geometry::{Vec3, add, dot, scale, sub};
use crate::model::state::TieField;
use crate::solver::fem::loads::{add_traction, at_nodes};
use crate::solver::solve::checkpoint::plastic::{Plastic, points};
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use rayon::prelude::*;

/// The field of each tie, at the displacements `u` and the plastic histories that belong to them.
pub fn tie_fields(
    model: &Model,
    (point, evaluation): (&Point, &Evaluation),
    plastic: &Plastic,
    u: &[[f64; 3]],
) -> Vec<TieField> {
    let tied = &model.all.tied;
    if tied.joints.is_empty() {
        return Vec::new();
    }
    let of_joint = tied.joints.iter().map(|joint| TieField {
        follows: joint.follows,
        distance: joint.distance,
        covered: joint.covered,
        ..TieField::default()
    });
    let mut fields: Vec<TieField> = of_joint.collect();
    let mut normals: Vec<Vec<Vec3>> = vec![Vec::new(); fields.len()];
    for node in &tied.areas {
        let field = &mut fields[node.tie as usize];
        field.nodes.push(node.node);
        field.area.push(node.area);
        field.force.push([0.0; 3]);
        normals[node.tie as usize].push(node.normal);
    }
    let mut left = left_over(model, (point, evaluation), plastic, u);
    tied.fold(&mut left, |follower, force| {
        let Some(tie) = follower.tie else { return };
        let field = &mut fields[tie as usize];
        let mut add_at = |component: u32, force: f64| {
            if let Ok(at) = field.nodes.binary_search(&(component / 3)) {
                field.force[at][component as usize % 3] += force;
            }
        };
        add_at(follower.component, force);
        // Functions of nodes that it stands for, too.
        (follower.terms.iter()).for_each(|(other, factor)| add_at(*other, -factor * force));
    });
    for (field, normals) in fields.iter_mut().zip(normals) {
        // On the side that is followed; told as it acts on the second one.
        let sign = if field.follows == 0 { 1.0 } else { -1.0 };
        for ((force, area), normal) in field.force.iter_mut().zip(&field.area).zip(normals) {
            let stress = scale(*force, 1.0 / area);
            let pressure = dot(stress, normal);
            field.pressure.push(pressure);
            let shear = sub(stress, scale(normal, pressure));
            field.shear.push(scale(shear, sign));
            *force = scale(*force, sign);
        }
    }
    fields
}

/// Loads less inner forces and contact, node by node.
fn left_over(
    model: &Model,
    (point, evaluation): (&Point, &Evaluation),
    plastic: &Plastic,
    u: &[[f64; 3]],
) -> Vec<Vec3> {
    let (scene, mesh) = (model.scene, &model.scene.mesh);
    let of_element = |e: usize| {
        let nodes = mesh.hexes[e];
        let elastic = &model.elastic[mesh.body_of(e)];
        let shape = model.element(e as u32);
        let force = shape.elastic_force(elastic, &nodes.map(|n| u[n as usize]));
        let free = model.free_strains(
            e as u32,
            points(plastic, e as u32),
            (point.step, point.time),
        );
        let relief = shape.relief(elastic, &free);
        let inner = std::array::from_fn(|k: usize| sub(relief[k], force[k]));
        (nodes, inner)
    };
    let inner: Vec<([u32; 8], [Vec3; 8])> = (0..mesh.hexes.len())
        .into_par_iter()
        .map(of_element)
        .collect();
    let mut left = at_nodes(mesh.points.len(), inner);
    for traction in &scene.tractions {
        if let Some(surface) = mesh.surface(&traction.surface) {
            let factor = scene.factor(&traction.name, point.step, point.time);
            add_traction(mesh, surface, traction.value, factor, &mut left);
        }
    }
    for (row, answer) in model.rows.iter().zip(&evaluation.contact) {
        let force = row.global(&answer.traction).map(|t| -t * row.row.area);
        for (node, coefficient) in &row.row.terms {
            let at = &mut left[*node as usize];
            *at = add(*at, [0, 1, 2].map(|i| coefficient[i] * force[i]));
        }
    }
    left
}
