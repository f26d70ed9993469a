//! Names of all that steps have factors for.

use crate::model::scene::Scene;

/// Tractions, rigid planes, supports and temperatures, by name.
pub fn load_names(scene: &Scene) -> impl Iterator<Item = &String> {
    (scene.tractions.iter().map(|t| &t.name))
        .chain(scene.rigid_planes.iter().map(|p| &p.name))
        .chain(scene.supports.iter().map(|s| &s.name))
        .chain(scene.temperatures.iter().map(|t| &t.name))
}
