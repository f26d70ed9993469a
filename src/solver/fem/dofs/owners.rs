//! What supports and rigid planes decide about displacement components.

use super::conflict::Conflict;
use super::owner::Owner;
use super::prescribed::Source;
use crate::ground::geometry::sub;
use crate::model::mesh::Mesh;
use crate::model::scene::{PlaneMotion, Scene};

/// What decides each component of each node; `None` where it is free.
pub type Owners = Vec<[Option<Owner>; 3]>;

/// What decides each component of `scene`.
///
/// # Errors
/// [`Conflict`] where supports and planes contradict each other.
pub fn owners(scene: &Scene) -> Result<Owners, Conflict> {
    let mesh = &scene.mesh;
    let mut owner = vec![[None::<Owner>; 3]; mesh.points.len()];
    let mut claim = |mesh: &Mesh, surface: &str, axis: usize, owns: &dyn Fn(u32) -> Owner| {
        for node in mesh.nodes_of_surface(surface) {
            let new = owns(node);
            let slot = &mut owner[node as usize][axis];
            match *slot {
                Some(old) if !old.agrees(&new, scene) => {
                    return Err(Conflict {
                        first: old.name(scene).to_owned(),
                        second: new.name(scene).to_owned(),
                        axis: ['x', 'y', 'z'][axis],
                        node,
                    });
                }
                Some(Owner::Plane(_)) => {}
                _ => *slot = Some(new),
            }
        }
        Ok(())
    };
    for (index, plane) in scene.rigid_planes.iter().enumerate() {
        let about = plane.point(mesh, &scene.mirrors);
        for axis in 0..3 {
            let owns = |node: u32| {
                let arm = sub(mesh.points[node as usize], about);
                let free = plane.free_turns(axis, arm).next().is_some();
                match plane.motion[axis] {
                    PlaneMotion::Held(value) if !free => {
                        let value = value + plane.given_turn(axis, arm);
                        Owner::Held(value, Source::Plane(index))
                    }
                    _ => Owner::Plane(index),
                }
            };
            if plane.motion[axis] != PlaneMotion::Free {
                claim(mesh, &plane.surface, axis, &owns)?;
            }
        }
    }
    for (index, support) in scene.supports.iter().enumerate() {
        for axis in 0..3 {
            if let Some(constant) = support.components[axis] {
                let owns = |node: u32| {
                    let value = support.displacement(axis, &mesh.points[node as usize]);
                    Owner::Held(value.unwrap_or(constant), Source::Support(index))
                };
                claim(mesh, &support.surface, axis, &owns)?;
            }
        }
    }
    Ok(owner)
}
