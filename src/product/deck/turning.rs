//! Rigid planes that turn: equations that tie their nodes to a point and to angles.

use super::driven::{Held, closing, surface};
use super::error::InpError;
use crate::ground::geometry::sub;
use crate::model::scene::{PlaneMotion, PlaneTurn, RigidPlane, Scene};
use crate::render::inp::{DeckFollower, Driven, Names, Turning};

/// The planes of `scene` that turn, each with two nodes of its own behind those of the mesh. Axes along which one is
/// driven by force are added to `driven`, and its nodes are `held` by it afterwards.
pub fn turning<'a>(
    scene: &'a Scene,
    names: &mut Names,
    driven: &mut Vec<Driven>,
    held: &mut Held<'a>,
) -> Result<Vec<Turning>, InpError> {
    let mut list = Vec::new();
    for (index, plane) in scene.rigid_planes.iter().enumerate() {
        if !plane.turns() {
            continue;
        }
        let reference = (scene.mesh.points.len() + 2 * list.len()) as u32;
        let face = surface(scene, &plane.name, &plane.surface)?;
        let at = plane.point(&scene.mesh, &scene.mirrors);
        let mut followers = Vec::new();
        for (axis, motion) in plane.motion.iter().enumerate() {
            if *motion == PlaneMotion::Free {
                continue;
            }
            if let PlaneMotion::Driven(force) = *motion {
                driven.push(Driven {
                    plane: plane.name.clone(),
                    axis,
                    force,
                    reference,
                    others: Vec::new(),
                    closing: closing(scene, plane, face, axis, force),
                });
            }
            for node in face.nodes() {
                let arm = sub(scene.mesh.points[node as usize], at);
                let levers = levers(plane, axis, arm);
                let Some(other) = held.insert((node, axis), &plane.name) else {
                    followers.push(DeckFollower { node, axis, levers });
                    continue;
                };
                // A mirror plane holds what this plane would not move there anyway.
                if *motion != PlaneMotion::Held(0.0) || !levers.is_empty() {
                    return Err(InpError::held_twice(node, plane, axis, other));
                }
            }
        }
        list.push(Turning {
            plane: index,
            set: names.unused(&format!("{}_point", plane.name)),
            at,
            reference,
            followers,
        });
    }
    Ok(list)
}

/// The axes that `plane` turns about or may, each with the motion along `axis` of a point at `arm` for an angle of one,
/// where there is any.
fn levers(plane: &RigidPlane, axis: usize, arm: [f64; 3]) -> Vec<(usize, f64)> {
    let free = RigidPlane {
        turn: plane.turn.map(|turn| match turn {
            PlaneTurn::Held(0.0) => turn,
            _ => PlaneTurn::Driven(0.0),
        }),
        ..RigidPlane::default()
    };
    free.free_turns(axis, arm).collect()
}
