//! Rigid planes that are driven by force.

use super::error::InpError;
use crate::model::mesh::Surface;
use crate::model::scene::{PlaneMotion, RigidPlane, Scene};
use crate::render::inp::Driven;
use crate::solver::fem::loads::area;
use std::collections::BTreeMap;

/// The surface of that name, which `user` names.
pub fn surface<'a>(scene: &'a Scene, user: &str, name: &str) -> Result<&'a Surface, InpError> {
    let missing = || InpError::NoSurface {
        user: user.to_string(),
        surface: name.to_string(),
    };
    scene.mesh.surface(name).ok_or_else(missing)
}

/// What is held along which axis, by the name of what holds it.
pub type Held<'a> = BTreeMap<(u32, usize), &'a str>;

/// What the supports hold.
pub fn held(scene: &Scene) -> Result<Held<'_>, InpError> {
    let mut held = Held::new();
    for support in &scene.supports {
        let nodes = surface(scene, &support.name, &support.surface)?.nodes();
        for axis in (0..3).filter(|a| support.components[*a].is_some()) {
            held.extend(nodes.iter().map(|n| ((*n, axis), support.name.as_str())));
        }
    }
    Ok(held)
}

/// The driven axes of all rigid planes that do not turn; their nodes are `held` by them afterwards.
pub fn driven<'a>(scene: &'a Scene, held: &mut Held<'a>) -> Result<Vec<Driven>, InpError> {
    let mut list = Vec::new();
    for plane in scene.rigid_planes.iter().filter(|plane| !plane.turns()) {
        let face = surface(scene, &plane.name, &plane.surface)?;
        let nodes = face.nodes();
        for (axis, motion) in plane.motion.iter().enumerate() {
            let PlaneMotion::Driven(force) = *motion else {
                continue;
            };
            for node in &nodes {
                if let Some(other) = held.insert((*node, axis), &plane.name) {
                    return Err(InpError::held_twice(*node, plane, axis, other));
                }
            }
            let [reference, others @ ..] = &nodes[..] else {
                continue;
            };
            list.push(Driven {
                plane: plane.name.clone(),
                axis,
                force,
                reference: *reference,
                others: others.to_vec(),
                closing: closing(scene, plane, face, axis, force),
            });
        }
    }
    Ok(list)
}

/// How far a force moves a plane: shortening of a solid block as long as the model, with the plane's area and its body's
/// modulus.
pub fn closing(
    scene: &Scene,
    plane: &RigidPlane,
    surface: &Surface,
    axis: usize,
    force: f64,
) -> f64 {
    let factor = scene
        .steps
        .first()
        .map_or(1.0, |s| s.factor_of(&plane.name));
    let area = area(&scene.mesh, surface);
    let body = surface.body(&scene.mesh).unwrap_or(0);
    let young = scene.materials.get(body).map_or(1.0, |s| s.youngs_modulus);
    (force * factor).abs() * scene.mesh.extent(axis) / (young * area)
}
