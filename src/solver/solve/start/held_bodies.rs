//! Bodies that are held along the load.

use crate::ground::geometry::Vec3;
use crate::model::scene::{PlaneMotion, Scene};

/// Bodies with a node whose displacement along the load is prescribed.
pub fn held_bodies(scene: &Scene, direction: Vec3) -> Vec<bool> {
    let mut held = vec![false; scene.mesh.bodies.len()];
    let mut mark = |surface: &str, axis: usize| {
        if direction[axis].abs() > 0.1
            && let Some(surface) = scene.mesh.surface(surface)
        {
            surface.bodies(&scene.mesh).for_each(|b| held[b] = true);
        }
    };
    for support in &scene.supports {
        for axis in (0..3).filter(|a| support.components[*a].is_some()) {
            mark(&support.surface, axis);
        }
    }
    for plane in &scene.rigid_planes {
        for axis in (0..3).filter(|a| matches!(plane.motion[*a], PlaneMotion::Held(_))) {
            mark(&plane.surface, axis);
        }
    }
    held
}
