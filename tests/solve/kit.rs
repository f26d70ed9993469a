//! What the tests of blocks share.

use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::scene::{Controls, Scene, Step, Support};

/// A scene of `mesh`, all of `steel`, in one step, with nothing on it yet.
pub fn scene(mesh: Mesh, steel: Steel) -> Scene {
    Scene {
        name: "block".into(),
        materials: vec![steel; mesh.bodies.len()],
        mesh,
        contacts: Vec::new(),
        supports: Vec::new(),
        rigid_planes: Vec::new(),
        tractions: Vec::new(),
        steps: vec![Step {
            name: "load".into(),
            factor: 1.0,
            factors: Vec::new(),
        }],
        mirrors: Vec::new(),
        temperatures: Vec::new(),
        ties: Vec::new(),
        half_turn: Vec::new(),
        controls: Controls::default(),
    }
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
