//! Planes on which supports hold both sides of a contact pair.

use crate::model::mesh::{Face, Mesh};
use crate::model::scene::{ContactPair, Scene};

/// Planes, by axis and coordinate, that supports hold both sides of a pair on.
pub fn held_planes(scene: &Scene, pair: &ContactPair) -> Vec<(usize, f64)> {
    let mesh = &scene.mesh;
    let of = |body: usize| -> Vec<(usize, f64)> {
        let held = scene.supports.iter().flat_map(|s| {
            let axes =
                (0..3).filter(|a| s.components[*a] == Some(0.0) && s.gradient[*a] == [0.0; 3]);
            axes.filter_map(|axis| Some((axis, plane_of(mesh, &s.surface, body, axis)?)))
        });
        held.collect()
    };
    match (pair.upper.body(mesh), pair.lower.body(mesh)) {
        (Some(upper), Some(lower)) => {
            let lower = of(lower);
            let both = of(upper).into_iter();
            both.filter(|plane| lower.contains(plane)).collect()
        }
        (Some(body), None) | (None, Some(body)) => of(body),
        (None, None) => Vec::new(),
    }
}

/// The coordinate along `axis` that all nodes of a surface of `body` have.
fn plane_of(mesh: &Mesh, surface: &str, body: usize, axis: usize) -> Option<f64> {
    let faces = &mesh.surface(surface)?.faces;
    let own = |face: &&Face| mesh.body_of(face.element as usize) == body;
    let mut nodes = faces.iter().filter(own).flat_map(|face| face.nodes);
    let at = mesh.points[nodes.next()? as usize][axis];
    let flat = nodes.all(|node| mesh.points[node as usize][axis] == at);
    flat.then_some(at)
}
