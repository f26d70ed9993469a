//! Direction of the resultant load.

use crate::ground::geometry::{Vec3, add, unit};
use crate::model::scene::{PlaneMotion, Scene};
use crate::solver::fem::loads::add_traction;

/// Direction of the resultant load, if there is one.
pub fn load_direction(scene: &Scene) -> Option<Vec3> {
    let mut force = [0.0; 3];
    for plane in &scene.rigid_planes {
        for (f, motion) in force.iter_mut().zip(plane.motion) {
            if let PlaneMotion::Driven(load) = motion {
                *f += load;
            }
        }
    }
    for traction in &scene.tractions {
        let Some(surface) = scene.mesh.surface(&traction.surface) else {
            continue;
        };
        let mut nodal = vec![[0.0; 3]; scene.mesh.points.len()];
        add_traction(&scene.mesh, surface, traction.value, 1.0, &mut nodal);
        for f in nodal {
            force = add(force, f);
        }
    }
    // A mirrored model carries no resultant across its mirrors.
    for &axis in &scene.mirrors {
        force[axis] = 0.0;
    }
    unit(force)
}
