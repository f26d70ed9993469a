//! How deep the elements below a surface are.

use crate::ground::geometry::{norm, sub};
use crate::model::mesh::Surface;
use crate::model::scene::Scene;

/// Depth of the elements below a node of a surface; `None` for a node that is not of it.
pub fn first_layer(scene: &Scene, surface: &Surface, node: u32) -> Option<f64> {
    let at = |n: u32| scene.mesh.points[n as usize];
    let faces = surface.faces.iter().filter(|f| f.nodes.contains(&node));
    let below = faces.flat_map(|face| {
        let nodes = scene.mesh.hexes[face.element as usize];
        nodes.into_iter().filter(|n| !face.nodes.contains(n))
    });
    let depths = below.map(|n| norm(sub(at(n), at(node))));
    depths.reduce(f64::min)
}
