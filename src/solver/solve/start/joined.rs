//! Bodies that ties join.

use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Scene;

/// Of each body the lowest one that ties join it to, by whatever way; itself where there is none.
pub fn joined(scene: &Scene) -> Vec<usize> {
    let mut group: Vec<usize> = (0..scene.mesh.bodies.len()).collect();
    for surfaces in scene.ties.iter().filter_map(|tie| tie.of(&scene.mesh)) {
        let bodies = surfaces.into_iter().flat_map(|s| bodies(&scene.mesh, s));
        let members: Vec<usize> = bodies.map(|body| group[body]).collect();
        let low = members.iter().copied().min().unwrap_or_default();
        for own in group.iter_mut().filter(|own| members.contains(own)) {
            *own = low;
        }
    }
    group
}

fn bodies<'m>(mesh: &'m Mesh, surface: &'m Surface) -> impl Iterator<Item = usize> + 'm {
    let faces = surface.faces.iter();
    faces.map(|face| mesh.body_of(face.element as usize))
}
