//! What loads, inner forces and contact leave over at nodes: what ties hand on, and what planes exert.

use crate::ground::geometry::{Vec3, add, sub};
use crate::model::scene::PlaneMotion;
use crate::solver::fem::loads::{add_traction, at_nodes};
use crate::solver::solve::checkpoint::plastic::{Plastic, points};
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use rayon::prelude::*;

/// Loads less inner forces and contact at the nodes that follow others or that a plane moves; whole at no other node.
pub fn left_over(
    model: &Model,
    (point, evaluation): (&Point, &Evaluation),
    plastic: &Plastic,
    u: &[[f64; 3]],
) -> Vec<Vec3> {
    let (scene, mesh) = (model.scene, &model.scene.mesh);
    let asked = asked(model);
    let elements: Vec<usize> = (0..mesh.hexes.len())
        .filter(|e| mesh.hexes[*e].iter().any(|n| asked[*n as usize]))
        .collect();
    if elements.is_empty() {
        return vec![[0.0; 3]; mesh.points.len()];
    }
    let of_element = |e: &usize| {
        let e = *e;
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
    let inner: Vec<([u32; 8], [Vec3; 8])> = elements.par_iter().map(of_element).collect();
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

/// Nodes that follow others or that a plane moves.
fn asked(model: &Model) -> Vec<bool> {
    let mesh = &model.scene.mesh;
    let nodes = 0..mesh.points.len() as u32;
    let mut asked: Vec<bool> = nodes.map(|node| model.all.tied.has(node)).collect();
    let planes = model.scene.rigid_planes.iter();
    let moved = planes.filter(|plane| plane.motion != [PlaneMotion::Free; 3]);
    for surface in moved.filter_map(|plane| mesh.surface(&plane.surface)) {
        for node in surface.nodes() {
            asked[node as usize] = true;
        }
    }
    asked
}
