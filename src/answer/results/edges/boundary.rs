//! Where surfaces end, and how large they are.

use std::collections::{BTreeMap, BTreeSet};

use super::super::hex::distance;
use super::super::line_frame::is_mirrored;
use super::super::own_directions::box_directions;
use crate::ground::geometry::{Vec3, dot, range};
use crate::model::mesh::Surface;
use crate::model::mesh::surface::sorted;
use crate::model::scene::Scene;
use crate::model::scene::held_planes::held_planes;

/// The longest side of the box about some nodes and their images, along directions of their own: as long whether mirror planes are made
/// use of or not, and however all is turned. `side` is one of a face, or of an element.
pub fn longest_side(scene: &Scene, nodes: &[u32], side: [u32; 2]) -> f64 {
    let length = |along: Vec3| {
        let [low, high] = range(
            nodes
                .iter()
                .map(|n| dot(along, scene.mesh.points[*n as usize])),
        );
        let size = high - low;
        let [near, far] = [low.abs().min(high.abs()), low.abs().max(high.abs())];
        // A surface apart from the plane is not the half of one.
        match is_mirrored(&along, &scene.mirrors) && near <= 1e-6 * far {
            true => 2.0 * far,
            false => size,
        }
    };
    let sides = box_directions(scene, nodes, side).map(length);
    sides.into_iter().fold(0.0, f64::max)
}

/// Edges where a surface ends, the nodes of each ascending.
pub type Boundary = BTreeSet<[u32; 2]>;

/// Edges that only one face of the surface has, the nodes of each ascending; without mirror planes.
pub fn boundary(scene: &Scene, surface: &Surface) -> Boundary {
    let mut uses: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for face in &surface.faces {
        for side in 0..4 {
            *uses.entry(face.edge(side)).or_default() += 1;
        }
    }
    // Where nodes hang a face ends at two smaller ones.
    for hanging in &scene.mesh.hanging {
        if let [a, b] = *hanging.corners.as_slice() {
            let m = hanging.node;
            let sides = [[a, b], sorted([a, m]), sorted([b, m])];
            if sides.iter().all(|side| uses.contains_key(side)) {
                sides.iter().for_each(|side| {
                    uses.remove(side);
                });
            }
        }
    }
    let once = uses.iter().filter(|(_, n)| **n == 1).map(|(edge, _)| *edge);
    let held = held_planes(scene, |_| true);
    let kept = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|n| scene.mesh.points[n as usize]);
        let tolerance = 1e-6 * distance(a, b);
        let mut mirrors = scene.mirrors.iter().filter(|axis| **axis < 3);
        let is_mirrored =
            mirrors.any(|axis| a[*axis].abs() <= tolerance && b[*axis].abs() <= tolerance);
        is_mirrored
            || held
                .iter()
                .any(|held| edge.iter().all(|n| held.nodes.binary_search(n).is_ok()))
    };
    once.filter(|edge| !kept(edge)).collect()
}
