//! The applied load of a scene, and what a force on the modelled part is for the whole.

use super::quad::{area, area_vector, integrate};
use super::{PlaneField, State};
use crate::geometry::{dot, norm};
use crate::mesh::Mesh;
use crate::scene::{PlaneMotion, Scene, TractionValue};

/// How many times the modelled part makes the whole: each mirror doubles.
pub fn copies(scene: &Scene) -> f64 {
    scene.mirrors.iter().fold(1.0, |copies, _| 2.0 * copies)
}

/// The force on the whole, from the force on the modelled part: each mirror doubles it, and
/// cancels the component along the mirrored axis.
pub fn whole(scene: &Scene, modelled: [f64; 3]) -> [f64; 3] {
    let mut force = modelled.map(|f| f * copies(scene));
    for &axis in scene.mirrors.iter().filter(|axis| **axis < 3) {
        force[axis] = 0.0;
    }
    force
}

/// Factor of the support, plane or traction called `name` at share `time` of step `step`.
pub fn factor(scene: &Scene, name: &str, step: usize, time: f64) -> f64 {
    let end_of = |i: usize| scene.steps.get(i).map_or(1.0, |s| s.factor_of(name));
    let start = if step == 0 { 0.0 } else { end_of(step - 1) };
    start + (end_of(step) - start) * time
}

/// Total force of driven planes and tractions on the whole, each times `factor` of its name.
fn driven(scene: &Scene, factor: impl Fn(&str) -> f64) -> [f64; 3] {
    let mut total = [0.0; 3];
    let mut add = |force: [f64; 3], factor: f64| {
        for (t, f) in total.iter_mut().zip(force) {
            *t += f * factor;
        }
    };
    for plane in &scene.rigid_planes {
        let force = plane.motion.map(|m| {
            if let PlaneMotion::Driven(f) = m {
                f
            } else {
                0.0
            }
        });
        add(force, factor(&plane.name));
    }
    for traction in &scene.tractions {
        let Some(surface) = scene.mesh.surface(&traction.surface) else {
            continue;
        };
        for face in &surface.faces {
            let corners = face_corners(&scene.mesh, face.nodes);
            add(
                face_force(&traction.value, &corners),
                factor(&traction.name),
            );
        }
    }
    whole(scene, total)
}

/// Total force of driven planes and tractions on the whole, every factor being one.
pub fn full(scene: &Scene) -> [f64; 3] {
    driven(scene, |_| 1.0)
}

/// Direction of prescribed plane motions.
fn held(scene: &Scene) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for plane in &scene.rigid_planes {
        for (s, m) in sum.iter_mut().zip(plane.motion) {
            if let PlaneMotion::Held(u) = m {
                *s += u;
            }
        }
    }
    sum
}

/// Unit vector along the applied load: of the resultant of driven planes and tractions at factor
/// one, else of the prescribed motion of the planes, else straight down.
pub fn direction(scene: &Scene) -> [f64; 3] {
    let force = driven(scene, |_| 1.0);
    let along = if norm(force) > 0.0 {
        force
    } else {
        held(scene)
    };
    let length = norm(along);
    if length > 0.0 {
        along.map(|x| x / length)
    } else {
        [0.0, 0.0, -1.0]
    }
}

/// The axis next to the load.
pub fn upright(scene: &Scene) -> usize {
    let along = direction(scene).map(f64::abs);
    (0..3)
        .max_by(|a, b| along[*a].total_cmp(&along[*b]))
        .unwrap_or(2)
}

/// Load on the whole along [`direction`]: the applied forces at the time of `state`, or, where
/// motion is prescribed, the force that the moved planes exert.
pub fn applied(scene: &Scene, state: &State) -> f64 {
    let along = direction(scene);
    if norm(driven(scene, |_| 1.0)) > 0.0 {
        return dot(
            driven(scene, |name| factor(scene, name, state.step, state.time)),
            along,
        );
    }
    let moved = |motion: &[PlaneMotion; 3]| {
        motion
            .iter()
            .any(|m| matches!(m, PlaneMotion::Held(u) if *u != 0.0))
    };
    let mut force = [0.0; 3];
    for (plane, field) in scene.rigid_planes.iter().zip(&state.planes) {
        if moved(&plane.motion) {
            for (f, p) in force.iter_mut().zip(field.force) {
                *f += p;
            }
        }
    }
    dot(whole(scene, force), along)
}

/// Travel along [`direction`] of what loads the scene: of the first rigid plane that is driven,
/// else of the first that is moved, else of the surfaces under traction, weighted by their
/// tractions: the work of the load over the load. `None` where nothing loads it.
pub fn descent(scene: &Scene, state: &State) -> Option<f64> {
    let along = direction(scene);
    let find = |loads: fn(&PlaneMotion) -> bool| -> Option<&PlaneField> {
        let index = scene
            .rigid_planes
            .iter()
            .position(|p| p.motion.iter().any(loads))?;
        state.planes.get(index)
    };
    find(|m| matches!(m, PlaneMotion::Driven(f) if *f != 0.0))
        .or_else(|| find(|m| matches!(m, PlaneMotion::Held(u) if *u != 0.0)))
        .map(|plane| dot(plane.travel, along))
        .or_else(|| travel_of_tractions(scene, state, along))
}

/// Displacement along `along`, averaged over the surfaces under traction with its component along
/// it as weight.
fn travel_of_tractions(scene: &Scene, state: &State, along: [f64; 3]) -> Option<f64> {
    let (mut work, mut load) = (0.0, 0.0);
    for traction in &scene.tractions {
        let surface = scene.mesh.surface(&traction.surface)?;
        for face in &surface.faces {
            let corners = face_corners(&scene.mesh, face.nodes);
            let moved = face
                .nodes
                .map(|n| dot(state.displacement[n as usize], along));
            let force = dot(face_force(&traction.value, &corners), along);
            integrate(&corners, |shape, weight| {
                let travel: f64 = shape.iter().zip(moved).map(|(n, u)| n * u).sum();
                work += force / area(&corners) * travel * weight;
            });
            load += force;
        }
    }
    (load > 0.0).then(|| work / load)
}

/// Force of a traction on a face.
fn face_force(traction: &TractionValue, corners: &[[f64; 3]; 4]) -> [f64; 3] {
    match traction {
        TractionValue::Pressure(p) => area_vector(corners).map(|a| -p * a),
        TractionValue::Vector(t) => t.map(|t| t * area(corners)),
    }
}

/// Corner coordinates of a face.
pub(super) fn face_corners(mesh: &Mesh, nodes: [u32; 4]) -> [[f64; 3]; 4] {
    nodes.map(|n| mesh.points[n as usize])
}
