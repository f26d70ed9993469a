//! Tractions as forces on nodes.

use crate::model::scene::{Scene, Step, Traction, TractionValue};
use crate::render::inp::NodalForce;
use crate::solver::fem::loads::add_traction;

/// For each traction of the scene its forces in `step`; empty for a pressure, which decks know.
pub fn nodal_forces(scene: &Scene, step: &Step) -> Vec<Vec<NodalForce>> {
    let mesh = &scene.mesh;
    let of = |traction: &Traction| {
        let (Some(surface), TractionValue::Vector(vector)) =
            (mesh.surface(&traction.surface), traction.value)
        else {
            return Vec::new();
        };
        // Also those of a factor of zero: a deck keeps what a step does not give anew.
        let acts = |axis: &usize| vector[*axis] != 0.0;
        let factor = step.factor_of(&traction.name);
        let mut forces = vec![[0.0; 3]; mesh.points.len()];
        add_traction(mesh, surface, traction.value, factor, &mut forces);
        let nodes = surface.nodes().into_iter();
        let components = nodes.flat_map(|node| {
            let force = forces[node as usize];
            (0..3).filter(acts).map(move |axis| NodalForce {
                node,
                axis,
                force: force[axis],
            })
        });
        components.collect()
    };
    scene.tractions.iter().map(of).collect()
}
