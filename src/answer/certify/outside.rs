//! The outsides of the bodies of a scene.

use crate::answer::results::outer_faces::OuterFaces;
use crate::model::mesh::split::volume_beyond_facets;
use crate::model::scene::Scene;
use std::cell::OnceCell;

/// What bars ask of the outsides of bodies, which is the same in every state of a scene.
pub struct Outside<'s> {
    scene: &'s Scene,
    pub(super) faces: OuterFaces<'s>,
    /// Of each body, where it was asked for.
    beyond_facets: Vec<OnceCell<f64>>,
}

impl<'s> Outside<'s> {
    /// That of the bodies of a scene.
    pub fn of(scene: &'s Scene) -> Self {
        Self {
            scene,
            faces: OuterFaces::of(scene),
            beyond_facets: vec![OnceCell::new(); scene.mesh.bodies.len()],
        }
    }

    /// See [`volume_beyond_facets`].
    pub(super) fn beyond_facets(&self, body: usize) -> f64 {
        let find = || volume_beyond_facets(&self.scene.mesh, body);
        *self.beyond_facets[body].get_or_init(find)
    }
}
