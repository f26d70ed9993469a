//! The start: bodies that float until they touch are moved until they do.
//!
//! A force on a body that nothing holds has no equilibrium. So, before any load, every body that
//! no support holds along the load is moved along it, one after the other from the supported ones
//! outward, until it just touches. From there the displacements count.
//!
//! "Touch" is meant in the measure of the contact method itself: the least weighted gap is zero. A
//! cylinder on a flat with elements of size h then overlaps by about h²/12R at its lowest point,
//! and the descent from there converges with a far smaller constant than from the touch of points.

use super::rows;
use crate::ground::geometry::{Vec3, dot, scale, unit};
use crate::model::scene::{ContactPair, Partner, PlaneMotion, Scene};
use crate::solver::contact::mortar::Row;

/// How far a body was moved to close its gap.
#[derive(Debug, Clone, PartialEq)]
pub struct Closing {
    /// Name of the body.
    pub body: String,
    /// By how much it was moved.
    pub shift: Vec3,
}

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
        crate::solver::fem::loads::add_traction(
            &scene.mesh,
            surface,
            traction.value,
            1.0,
            &mut nodal,
        );
        for f in nodal {
            force = crate::ground::geometry::add(force, f);
        }
    }
    // A mirrored model carries no resultant across its mirrors.
    for &axis in &scene.mirrors {
        force[axis] = 0.0;
    }
    unit(force)
}

/// The initial gap up to which contact is integrated: a little more than bodies approach each other
/// in small-strain contact, and all that they are made to travel.
pub fn reach(scene: &Scene) -> f64 {
    scene.controls.contact_reach * (1e-3 * extent(scene)).max(2.0 * travel(scene))
}

/// The initial gap, over the least one, up to which contact is likely to close.
pub fn likely_gap(scene: &Scene) -> f64 {
    scene.controls.contact_reach * (1e-4 * extent(scene)).max(2.0 * travel(scene))
}

/// The largest displacement that is prescribed.
fn travel(scene: &Scene) -> f64 {
    let factors = |name: &str| {
        let factors = scene.steps.iter().map(|s| s.factor_of(name).abs());
        factors.fold(0.0, f64::max)
    };
    let supports = scene.supports.iter().flat_map(|s| {
        let factor = factors(&s.name);
        s.components.iter().flatten().map(move |v| v.abs() * factor)
    });
    let planes = scene.rigid_planes.iter().flat_map(|p| {
        let factor = factors(&p.name);
        p.motion.iter().map(move |m| match m {
            PlaneMotion::Held(v) => v.abs() * factor,
            _ => 0.0,
        })
    });
    supports.chain(planes).fold(0.0, f64::max)
}

/// How often a body is moved at most.
const ROUNDS: usize = 12;

/// Moves floating bodies into touch, as close as a solution asks for, and reports what was moved.
pub fn touch(scene: &mut Scene) -> Vec<Closing> {
    close_gaps(scene, 1e-10 * extent(scene))
}

/// Moves floating bodies into touch to `tolerance` and reports what was moved.
pub fn close_gaps(scene: &mut Scene, tolerance: f64) -> Vec<Closing> {
    let Some(direction) = load_direction(scene) else {
        return Vec::new();
    };
    let mut placed = held_bodies(scene, direction);
    let mut closings = Vec::new();
    let mut ways = vec![None; scene.contacts.len()];
    while placed.iter().any(|p| !p) {
        let nearest = nearest_floating(scene, &placed, &|_| true, direction, &mut ways);
        let Some((body, distance)) = nearest else {
            break;
        };
        let mut way = distance;
        let mut total = 0.0;
        // The gap of a curved side is not quite linear in the way: again, until it is closed.
        for _ in 0..ROUNDS {
            if way.abs() <= tolerance {
                break;
            }
            total += way;
            move_body(scene, body, scale(direction, way));
            let mut fresh = vec![None; scene.contacts.len()];
            let only = |other: usize| other == body;
            let rest = nearest_floating(scene, &placed, &only, direction, &mut fresh);
            way = rest.map_or(0.0, |(_, way)| way);
        }
        placed[body] = true;
        if total != 0.0 {
            closings.push(Closing {
                body: scene.mesh.bodies[body].name.clone(),
                shift: scale(direction, total),
            });
        }
    }
    closings
}

/// Bodies with a node whose displacement along the load is prescribed.
fn held_bodies(scene: &Scene, direction: Vec3) -> Vec<bool> {
    let mut held = vec![false; scene.mesh.bodies.len()];
    let mut mark = |surface: &str, axis: usize| {
        if direction[axis].abs() > 0.1
            && let Some(surface) = scene.mesh.surface(surface)
        {
            for face in &surface.faces {
                held[scene.mesh.body_of(face.element as usize)] = true;
            }
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

/// The floating `candidate` that touches what is placed after the shortest way, and that way along the
/// load. `ways` keeps the way of each pair between a placed body and a floating one: neither moves
/// until the latter is placed.
fn nearest_floating(
    scene: &Scene,
    placed: &[bool],
    candidate: &dyn Fn(usize) -> bool,
    direction: Vec3,
    ways: &mut [Option<Option<f64>>],
) -> Option<(usize, f64)> {
    let body_of = |partner: &Partner| match partner {
        Partner::Surface(name) => {
            let face = scene.mesh.surface(name)?.faces.first()?;
            Some(Some(scene.mesh.body_of(face.element as usize)))
        }
        Partner::Plane { .. } => Some(None),
    };
    let mut best: Option<(usize, f64)> = None;
    for (pair, known) in scene.contacts.iter().zip(ways) {
        let (Some(upper), Some(lower)) = (body_of(&pair.upper), body_of(&pair.lower)) else {
            continue;
        };
        let is_placed = |body: Option<usize>| body.is_none_or(|b| placed[b]);
        let body = match (is_placed(upper), is_placed(lower)) {
            (true, false) => lower,
            (false, true) => upper,
            _ => continue,
        };
        let Some(body) = body.filter(|b| candidate(*b)) else {
            continue;
        };
        let way = known.get_or_insert_with(|| way_to_touch(scene, pair, direction));
        if let Some(way) = *way
            && best.is_none_or(|(_, b)| way.abs() < b.abs())
        {
            best = Some((body, way));
        }
    }
    best
}

/// Distance along the load until the two sides touch.
fn way_to_touch(scene: &Scene, pair: &ContactPair, direction: Vec3) -> Option<f64> {
    let row = nearest_row(scene, pair)?;
    let lean = dot(row.normal, direction).abs();
    (lean > 0.1).then(|| row.gap / lean)
}

/// The row of a pair with the least initial gap; `None` where nothing of the two sides faces each
/// other.
pub fn nearest_row(scene: &Scene, pair: &ContactPair) -> Option<Row> {
    let moduli = vec![1.0; scene.materials.len()];
    let whole = extent(scene);
    let mut reach = 1e-3 * whole;
    while reach < 2.0 * whole {
        let rows = rows::pair_rows(scene, pair, reach, &moduli);
        let nearest = rows.into_iter().min_by(|a, b| a.gap.total_cmp(&b.gap));
        if nearest.is_some() {
            return nearest;
        }
        reach *= 8.0;
    }
    None
}

/// Diagonal of the box around the model.
pub fn extent(scene: &Scene) -> f64 {
    let span = |axis: usize| {
        let (low, high) = scene
            .mesh
            .points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| {
                (l.min(p[axis]), h.max(p[axis]))
            });
        high - low
    };
    span(0).hypot(span(1)).hypot(span(2))
}

fn move_body(scene: &mut Scene, body: usize, shift: Vec3) {
    let mut moved = vec![false; scene.mesh.points.len()];
    for element in scene.mesh.bodies[body].elements.clone() {
        for node in scene.mesh.hexes[element] {
            if !std::mem::replace(&mut moved[node as usize], true) {
                let point = &mut scene.mesh.points[node as usize];
                *point = crate::ground::geometry::add(*point, shift);
            }
        }
    }
}
