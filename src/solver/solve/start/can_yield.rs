//! Elements of steels that yield.

use crate::model::scene::Scene;

/// Is the element of a steel that yields?
pub fn can_yield(scene: &Scene, element: u32) -> bool {
    let body = scene.mesh.body_of(element as usize);
    scene.controls.plasticity && !scene.materials[body].is_elastic()
}
