//! Where surfaces end, and how large they are.

use std::collections::{BTreeMap, BTreeSet};

use super::super::hex::distance;
use crate::ground::geometry::bounds;
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Scene;

/// The longest side of the box about some nodes and their images: as long whether mirror planes are made use of or not.
pub fn longest_side(scene: &Scene, nodes: impl Iterator<Item = u32>) -> f64 {
    let [mut low, mut high] = bounds(nodes.map(|node| scene.mesh.points[node as usize]));
    let size = distance(low, high);
    for axis in scene.mirrors.iter().copied().filter(|axis| *axis < 3) {
        // A surface apart from the plane is not the half of one.
        if low[axis].abs().min(high[axis].abs()) <= 1e-6 * size {
            let half = low[axis].abs().max(high[axis].abs());
            (low[axis], high[axis]) = (-half, half);
        }
    }
    (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max)
}

/// Diagonal of the box about a surface.
fn extent(mesh: &Mesh, surface: &Surface) -> f64 {
    let nodes = surface.faces.iter().flat_map(|face| face.nodes);
    let [low, high] = bounds(nodes.map(|node| mesh.points[node as usize]));
    distance(low, high)
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
    let held = held_planes(scene);
    let kept = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|n| scene.mesh.points[n as usize]);
        let tolerance = 1e-6 * distance(a, b);
        let mut mirrors = scene.mirrors.iter().filter(|axis| **axis < 3);
        let is_mirrored =
            mirrors.any(|axis| a[*axis].abs() <= tolerance && b[*axis].abs() <= tolerance);
        is_mirrored
            || held
                .iter()
                .any(|held| edge.iter().all(|n| held.contains(n)))
    };
    once.filter(|edge| !kept(edge)).collect()
}

/// Nodes of each flat surface across an axis that a support holds along it, as a mirror plane does.
fn held_planes(scene: &Scene) -> Vec<BTreeSet<u32>> {
    let mut planes = Vec::new();
    for support in &scene.supports {
        let Some(surface) = scene.mesh.surface(&support.surface) else {
            continue;
        };
        let nodes = surface.nodes();
        // Bodies are moved into touch along directions with rounding in them.
        let flat = 1e-9 * extent(&scene.mesh, surface);
        let is_flat = |axis: usize| {
            let mut at = nodes.iter().map(|n| scene.mesh.points[*n as usize][axis]);
            at.next()
                .is_some_and(|first| at.all(|x| (x - first).abs() <= flat))
        };
        let holds = |axis: &usize| {
            support.components[*axis] == Some(0.0) && support.gradient[*axis] == [0.0; 3]
        };
        if (0..3).filter(holds).any(is_flat) {
            planes.push(nodes.iter().copied().collect());
        }
    }
    planes
}
