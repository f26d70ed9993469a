//! Bodies that float until they touch are moved until they do.
//!
//! A force on a body that nothing holds has no equilibrium. So, before any load, every body that
//! no support holds along the load is moved along it, one after the other from the supported ones
//! outward, until it just touches. From there the displacements count.
//!
//! "Touch" is meant in the measure of the contact method itself: the least weighted gap is zero. A
//! cylinder on a flat with elements of size h then overlaps by about h²/12R at its lowest point,
//! and the descent from there converges with a far smaller constant than from the touch of points.

use crate::ground::geometry::{Vec3, add, dot, norm, scale};
use crate::model::scene::joined;
use crate::model::scene::{Partner, Scene, Side};
use crate::solver::contact::mortar::Row;
use crate::solver::solve::params::CLOSING_ROUNDS;
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::start::held_bodies::held_bodies;
use crate::solver::solve::start::load_direction::load_direction;
use crate::solver::solve::start::nearest_row::way_to_touch;

/// How far a body was moved to close its gap.
#[derive(Debug, Clone, PartialEq)]
pub struct Closing {
    /// Its name.
    pub body: String,
    /// In the length unit of the scene.
    pub shift: Vec3,
}

/// Moves floating bodies into touch, as close as rounding lets it, for what is left counts as descent, and reports what was moved by more than
/// next to nothing.
pub fn touch(scene: &mut Scene) -> Vec<Closing> {
    /// Of the size of the scene.
    const ROUNDING: f64 = 1e-13;
    const NOTHING: f64 = 1e-10;
    let size = extent(scene);
    let mut closings = close_gaps(scene, ROUNDING * size);
    closings.retain(|closing| norm(closing.shift) > NOTHING * size);
    closings
}

/// Moves floating bodies into touch to `tolerance` and reports what was moved.
pub fn close_gaps(scene: &mut Scene, tolerance: f64) -> Vec<Closing> {
    let Some(direction) = load_direction(scene) else {
        return Vec::new();
    };
    let joined = joined(scene);
    let mut placed = held_bodies(scene, direction);
    for body in 0..placed.len() {
        if placed[body] {
            place(&mut placed, &joined, body);
        }
    }
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
        for _ in 0..CLOSING_ROUNDS {
            if way.abs() <= tolerance {
                break;
            }
            total += way;
            move_bodies(scene, &joined, body, scale(direction, way));
            let mut fresh = vec![None; scene.contacts.len()];
            let only = |other: usize| joined[other] == joined[body];
            let rest = nearest_floating(scene, &placed, &only, direction, &mut fresh);
            way = rest.map_or(0.0, |(_, way)| way);
        }
        place(&mut placed, &joined, body);
        if total != 0.0 {
            closings.push(Closing {
                body: scene.mesh.bodies[body].name.clone(),
                shift: scale(direction, total),
            });
        }
    }
    closings
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
        Partner::Surface(_) => partner.body(&scene.mesh).map(Some),
        Partner::Plane { .. } => Some(None),
    };
    let mut best: Option<(usize, f64)> = None;
    for (pair, known) in scene.contacts.iter().zip(ways) {
        let (Some(upper), Some(lower)) = (body_of(&pair.upper), body_of(&pair.lower)) else {
            continue;
        };
        let is_placed = |body: Option<usize>| body.is_none_or(|b| placed[b]);
        let (body, floats) = match (is_placed(upper), is_placed(lower)) {
            (true, false) => (lower, Side::Lower),
            (false, true) => (upper, Side::Upper),
            _ => continue,
        };
        // Normals of rows lead from the carrier to the other side.
        let sign = if floats == pair.carrier { 1.0 } else { -1.0 };
        let rate = |row: &Row| sign * dot(row.normal, direction);
        let Some(body) = body.filter(|b| candidate(*b)) else {
            continue;
        };
        let way = known.get_or_insert_with(|| way_to_touch(scene, pair, rate));
        if let Some(way) = *way
            && best.is_none_or(|(_, b)| way.abs() < b.abs())
        {
            best = Some((body, way));
        }
    }
    best
}

/// The body stands, and with it all that is joined to it.
fn place(placed: &mut [bool], joined: &[usize], body: usize) {
    let own = joined.iter().zip(placed);
    own.filter(|(group, _)| **group == joined[body])
        .for_each(|(_, placed)| *placed = true);
}

/// Moves a body with all that is joined to it.
fn move_bodies(scene: &mut Scene, joined: &[usize], body: usize, shift: Vec3) {
    let mut moved = vec![false; scene.mesh.points.len()];
    let own = (0..joined.len()).filter(|other| joined[*other] == joined[body]);
    let elements = own.flat_map(|body| scene.mesh.bodies[body].elements.clone());
    for element in elements.collect::<Vec<_>>() {
        for node in scene.mesh.hexes[element] {
            if !std::mem::replace(&mut moved[node as usize], true) {
                let point = &mut scene.mesh.points[node as usize];
                *point = add(*point, shift);
            }
        }
    }
    for plane in &mut scene.rigid_planes {
        let surface = scene.mesh.surface(&plane.surface);
        let bounded = surface.and_then(|s| s.body(&scene.mesh));
        let own = bounded.is_some_and(|bounded| joined[bounded] == joined[body]);
        plane.about = plane.about.map(|at| if own { add(at, shift) } else { at });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::Body;
    use crate::model::mesh::block::{Block, uniform};
    use crate::model::scene::RigidPlane;

    #[test]
    fn the_point_of_a_plane_moves_with_all_that_is_joined() {
        let side = || uniform(0.0, 1.0, 1);
        let block = Block::new("block", side(), side(), uniform(0.0, 2.0, 2));
        let mut mesh = block.build().unwrap();
        let body = |(name, e): (&str, usize)| Body {
            name: name.into(),
            elements: e..e + 1,
        };
        mesh.bodies = [("lower", 0), ("upper", 1)].map(body).into();
        let mut scene = Scene::bare("joined", mesh, Steel::elastic(1.0, 0.3));
        scene.rigid_planes = vec![RigidPlane {
            surface: "z_max".into(),
            about: Some([0.5, 0.5, 2.0]),
            ..RigidPlane::default()
        }];
        move_bodies(&mut scene, &[0, 0], 0, [0.0, 0.0, -0.25]);
        assert_eq!(scene.rigid_planes[0].about, Some([0.5, 0.5, 1.75]));
        let top = scene.mesh.surface("z_max").unwrap().nodes();
        assert!(
            top.iter()
                .all(|n| scene.mesh.points[*n as usize][2] == 1.75)
        );
    }
}
