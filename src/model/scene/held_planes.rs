//! Planes that supports hold as mirror planes do.

use super::Scene;
use crate::ground::geometry::{bounds, norm, sub};
use crate::ground::order::ascending;
use crate::model::mesh::Face;

/// What a support keeps in a plane across an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldPlane {
    /// The axis.
    pub axis: usize,
    /// Its coordinate on that axis.
    pub at: f64,
    /// The nodes that are held in it, ascending.
    pub nodes: Vec<u32>,
}

/// The flat parts across an axis of what supports hold along it, of faces that count: of both ends of a slice that one support
/// holds, each.
pub fn held_planes(scene: &Scene, counts: impl Fn(&Face) -> bool) -> Vec<HeldPlane> {
    let mut planes: Vec<HeldPlane> = Vec::new();
    for support in &scene.supports {
        let Some(surface) = scene.mesh.surface(&support.surface) else {
            continue;
        };
        let holds = |axis: &usize| {
            support.components[*axis] == Some(0.0) && support.gradient[*axis] == [0.0; 3]
        };
        let axes: Vec<usize> = (0..3).filter(holds).collect();
        let point = |node: u32| scene.mesh.points[node as usize];
        let nodes = surface.faces.iter().flat_map(|face| face.nodes);
        let [low, high] = bounds(nodes.map(point));
        // Bodies are moved into touch along directions with rounding in them.
        let flat = 1e-9 * norm(sub(high, low));
        for face in surface.faces.iter().filter(|face| counts(face)) {
            let [least, most] = bounds(face.nodes.map(point));
            for axis in axes
                .iter()
                .copied()
                .filter(|k| most[*k] - least[*k] <= flat)
            {
                let at = least[axis];
                let own =
                    |plane: &&mut HeldPlane| plane.axis == axis && (plane.at - at).abs() <= flat;
                match planes.iter_mut().find(own) {
                    Some(plane) => plane.nodes.extend(face.nodes),
                    None => planes.push(HeldPlane {
                        axis,
                        at,
                        nodes: face.nodes.to_vec(),
                    }),
                }
            }
        }
    }
    for plane in &mut planes {
        plane.nodes = ascending(std::mem::take(&mut plane.nodes));
    }
    planes
}
