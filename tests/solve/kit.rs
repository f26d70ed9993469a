//! What the tests of blocks share.

use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::scene::{Scene, Support};

/// A scene of `mesh`, all of `steel`, with nothing on it yet.
pub fn scene(mesh: Mesh, steel: Steel) -> Scene {
    Scene::bare("block", mesh, steel)
}

/// Holds a surface along one axis.
pub fn held(surface: &str, axis: usize) -> Support {
    let mut components = [None; 3];
    components[axis] = Some(0.0);
    Support {
        name: surface.into(),
        surface: surface.into(),
        components,
        ..Support::default()
    }
}
