//! Where each equation acts, for dividing a large model into parts.

use crate::model::scene::Scene;
use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::linear::schwarz::Place;

/// Where each equation acts.
pub fn places(scene: &Scene, dofs: &DofMap) -> Vec<Place> {
    let mut places = vec![None; dofs.len()];
    let mut nodes = vec![0u32; dofs.len()];
    for (node, (equations, point)) in dofs.equations.iter().zip(&scene.mesh.points).enumerate() {
        if dofs.turned.get(node) == Some(&true) {
            continue;
        }
        for (axis, equation) in equations.iter().enumerate() {
            // On the axis of a half turn y goes with x.
            if *equation != FIXED && !equations[..axis].contains(equation) {
                places[*equation as usize] = Some((*point, axis));
                nodes[*equation as usize] += 1;
            }
        }
    }
    // The motion of a rigid plane.
    let shared = places.iter_mut().zip(nodes).filter(|(_, n)| *n > 1);
    shared.for_each(|(place, _)| *place = None);
    places
}
