//! Planes on which supports hold both sides of a contact pair.

use crate::model::mesh::Face;
use crate::model::scene::held_planes::{HeldPlane, held_planes};
use crate::model::scene::{ContactPair, Scene};

/// Of the size of a scene, how far apart the planes of both sides may be: coordinates are rounded.
const SAME_PLANE: f64 = 1e-9;

/// Planes, by axis and coordinate, that supports hold both sides of a pair on.
pub fn held_on_both(scene: &Scene, pair: &ContactPair) -> Vec<(usize, f64)> {
    let mesh = &scene.mesh;
    let of = |body: usize| {
        held_planes(scene, |face: &Face| {
            mesh.body_of(face.element as usize) == body
        })
    };
    let both = match (pair.upper.body(mesh), pair.lower.body(mesh)) {
        (Some(upper), Some(lower)) => {
            let reach = [0, 1, 2].map(|axis| SAME_PLANE * mesh.extent(axis));
            let lower = of(lower);
            let near = |own: &HeldPlane| {
                let same = |other: &HeldPlane| {
                    own.axis == other.axis && (own.at - other.at).abs() <= reach[own.axis]
                };
                lower.iter().any(same)
            };
            let mut upper = of(upper);
            upper.retain(near);
            upper
        }
        (Some(body), None) | (None, Some(body)) => of(body),
        (None, None) => Vec::new(),
    };
    both.into_iter()
        .map(|plane| (plane.axis, plane.at))
        .collect()
}
