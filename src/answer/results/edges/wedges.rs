//! Edges of bodies at which elastic stresses are singular whatever presses: inner corners, edges of what is held, rims of
//! what is joined.
//!
//! At an edge two outer faces of a body enclose a wedge. Stresses near its tip go with a power of the distance, which is
//! negative from a certain angle on, by what the two faces may do (Williams, Stress singularities resulting from various
//! boundary conditions in angular corners of plates in extension, J. Appl. Mech. 19, 1952): 180 degrees where both are
//! free or both are held, 63 where one is held and the other free, 90 where one is held as by a mirror, as the image
//! doubles the wedge. Next to these angles the power is so small that no mesh shows it.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::super::hex::distance;
use super::super::outer_faces::{Bound, OuterFaces};
use super::super::seams::Seams;
use super::boundary::longest_side;
use super::reach::EdgeNodes;
use crate::ground::geometry::{Vec3, add, dot, scale, sub};
use crate::model::mesh::Face;
use crate::model::scene::{EDGE_REACH, Scene};

/// Angle of a wedge of one held and one free face from which on it is singular, of π. (Williams: 63 degrees for ν = 0.3.)
const HELD: f64 = 70.0 / 180.0;
/// Angle of a wedge that a mirror doubles, of π.
const SLIDING: f64 = 105.0 / 180.0;
/// Angle of a wedge of two faces of one kind, of π.
const ALIKE: f64 = 210.0 / 180.0;
/// Where a round surface is meshed by facets each turns as much as the next; an edge turns more than twice as much.
const SHARP: f64 = 2.0;

/// An edge of a body.
struct Wedge {
    body: usize,
    /// Inside of the body, in radians.
    angle: f64,
    bounds: [Bound; 2],
    nodes: [u32; 2],
    /// One of its faces, and which of its sides the edge is.
    face: Face,
    side: usize,
}

/// Nodes on the singular edges of all bodies.
pub(super) fn singular(scene: &Scene) -> EdgeNodes {
    let wedges = wedges(scene);
    let joined: Vec<&Wedge> = (wedges.iter())
        .filter(|wedge| wedge.bounds.contains(&Bound::Joined))
        .collect();
    let mut nodes = EdgeNodes::default();
    let mut reaches: BTreeMap<usize, f64> = BTreeMap::new();
    for wedge in &wedges {
        let is_singular = match wedge.bounds {
            [Bound::Joined, Bound::Joined] => false,
            [Bound::Joined, other] | [other, Bound::Joined] => {
                is_singular_rim(scene, wedge, other, &joined)
            }
            bounds => is_singular(bounds, wedge.angle),
        };
        if is_singular {
            let whole = *reaches.entry(wedge.body).or_insert_with(|| {
                let elements = scene.mesh.bodies[wedge.body].elements.clone();
                let first = scene.mesh.hexes[elements.start];
                let nodes = scene.mesh.nodes_of_body(wedge.body);
                EDGE_REACH * longest_side(scene, &nodes, [first[0], first[1]])
            });
            nodes.add(&scene.mesh, &wedge.face, wedge.side, whole);
        }
    }
    nodes
}

/// Is a wedge singular whose faces may do this?
fn is_singular(bounds: [Bound; 2], angle: f64) -> bool {
    let from = match bounds {
        [Bound::Cut | Bound::Joined, _] | [_, Bound::Cut | Bound::Joined] => return false,
        // Along a plane, and where two planes meet squarely, as of a plate between rollers.
        [Bound::Slides, Bound::Slides] => return false,
        [Bound::Slides, _] | [_, Bound::Slides] => SLIDING,
        [Bound::Held, Bound::Free] | [Bound::Free, Bound::Held] => HELD,
        [Bound::Free, Bound::Free] | [Bound::Held, Bound::Held] => ALIKE,
    };
    angle > from * PI
}

/// Is the rim of what is joined singular? The wedges of the bodies that meet there make one, of one steel or of two.
fn is_singular_rim(scene: &Scene, wedge: &Wedge, other: Bound, joined: &[&Wedge]) -> bool {
    let mesh = &scene.mesh;
    let [a, b] = wedge.nodes.map(|node| mesh.points[node as usize]);
    let (middle, near) = (scale(add(a, b), 0.5), 0.1 * distance(a, b));
    let mut beyond: BTreeMap<usize, &Wedge> = BTreeMap::new();
    for found in joined.iter().filter(|found| found.body != wedge.body) {
        let [a, b] = found.nodes.map(|node| mesh.points[node as usize]);
        if off_segment(middle, a, b) <= near {
            beyond.entry(found.body).or_insert(found);
        }
    }
    // Where no edge of the other body is, its surface goes on to both sides.
    let angles = beyond.values().map(|found| found.angle);
    let angle = wedge.angle + if beyond.is_empty() { PI } else { angles.sum() };
    let free = |wedge: &&Wedge| {
        let mut bounds = wedge.bounds.into_iter();
        bounds.find(|bound| *bound != Bound::Joined)
    };
    let opposite = beyond.values().find_map(free).unwrap_or(Bound::Free);
    let bounds = [other, opposite];
    if bounds.contains(&Bound::Slides) {
        // A plane interface that meets a mirror squarely is whole.
        return angle > SLIDING * PI * 2.0;
    }
    !is_of_one_steel(scene, wedge.body, beyond.keys().copied()) && !bounds.contains(&Bound::Cut)
        || is_singular(bounds, angle)
}

/// Are the bodies of one elastic steel? Those that `wedge` is tied to without an edge of theirs are not known here: then all
/// of the scene are asked.
fn is_of_one_steel(scene: &Scene, body: usize, beyond: impl Iterator<Item = usize>) -> bool {
    let steel =
        |body: usize| (scene.materials.get(body)).map(|s| [s.youngs_modulus, s.poissons_ratio]);
    let mut others: Vec<usize> = beyond.collect();
    if others.is_empty() {
        others.extend(0..scene.mesh.bodies.len());
    }
    others.into_iter().all(|other| steel(other) == steel(body))
}

/// Distance of a point from the straight line between two others.
pub(super) fn off_segment(at: Vec3, a: Vec3, b: Vec3) -> f64 {
    let along = sub(b, a);
    let share = dot(sub(at, a), along) / dot(along, along).max(f64::MIN_POSITIVE);
    distance(at, add(a, scale(along, share.clamp(0.0, 1.0))))
}

/// The edges of all bodies at which two outer faces meet that are not parts of one smooth surface doing one thing.
fn wedges(scene: &Scene) -> Vec<Wedge> {
    let mesh = &scene.mesh;
    let outer = OuterFaces::of(scene);
    let mut found = Vec::new();
    for (body, faces) in outer.by_body.iter().enumerate() {
        let seams = Seams::of(faces);
        let kinds: Vec<Bound> = faces.iter().map(|face| outer.bound(face)).collect();
        for (nodes, shared) in seams.all() {
            let (&[first, second], Some((own, _))) = (shared, seams.turn(mesh, nodes)) else {
                continue;
            };
            let (a, side) = first;
            let pair = [kinds[a], kinds[second.0]];
            if pair[0] == pair[1] {
                // Along a round surface the next facets turn as much.
                let opposite = [first, second].map(|side| seams.turn_opposite(mesh, side));
                let turns = opposite.into_iter().flatten().map(|(turn, _)| turn);
                let next = turns.fold(0.0, f64::min);
                if own >= SHARP * next {
                    continue;
                }
            }
            found.push(Wedge {
                body,
                angle: PI - own,
                bounds: pair,
                nodes,
                face: faces[a],
                side,
            });
        }
    }
    found
}
