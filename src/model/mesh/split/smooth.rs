//! Edges on surfaces that are smooth but of no known shape: an ellipse, a fillet that runs into a plane, a hole without a
//! name.
//!
//! Left straight, a chord would keep its corners however often it is split, and the stress at a corner has no bound. Facets
//! of a smooth surface turn by little from one to the next. Through the ends of an edge goes an arc with the tangents that
//! the turns there say: each takes the share of the turn that its length is of both, all of it beside a plane. On a circle
//! the middle of that arc lies on the circle.

use crate::ground::geometry::{Vec3, add, dot, norm, scale, sub, unit};
use crate::model::mesh::hexahedron::volume;
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Face, Mesh};
use std::collections::{HashMap, HashSet};
use std::f64::consts::FRAC_PI_2;

/// Facets that turn by more, in radians (40 degrees), meet at an edge, as those of a round shape may
/// ([`fit`](crate::model::mesh::shape::fit)).
const MOST_TURN: f64 = 0.7;
/// Angle by which rounded coordinates may turn a facet, in radians.
const NO_TURN: f64 = 1e-3;
/// Of the turn at one end of a facet, how far it may be off square to the face that the surface ends at beyond the other, and
/// still be flat: a chord of a circle leans by half of that turn to the plane of a mirror.
const SQUARE: f64 = 0.1;

/// How a surface goes on across a side of a facet.
#[derive(Clone, Copy)]
enum Across {
    /// It ends, or at an edge. The facet `leans` by an angle off square to the face beyond.
    Edge { leans: f64 },
    /// In the same plane.
    Flat,
    /// It turns by an angle, convex positive, into another facet, seen from that one's side.
    Turns { by: f64, into: (usize, usize) },
}

/// The outer facets of a body.
struct Skin<'m> {
    mesh: &'m Mesh,
    faces: Vec<Face>,
    normals: Vec<Vec3>,
    /// The facets that have an edge, each with its side.
    at: HashMap<[u32; 2], Vec<(usize, usize)>>,
}

/// From the middle of an edge to that of the arc over it, for the edges of smooth surfaces. `flat` are facets that are known
/// to be plane.
pub(super) fn bulges(mesh: &Mesh, flat: &HashSet<[u32; 4]>) -> HashMap<[u32; 2], Vec3> {
    let mut bulges: HashMap<[u32; 2], Vec3> = HashMap::new();
    for body in 0..mesh.bodies.len() {
        let skin = Skin::new(mesh, body);
        for (edge, sides) in &skin.at {
            let mut sum = [0.0; 3];
            for (face, side) in sides {
                let is_flat = flat.contains(&sorted(skin.faces[*face].nodes));
                let bulge = if is_flat {
                    None
                } else {
                    skin.bulge(*face, *side)
                };
                // Across an edge of the body each surface has its own say, along its normal; else they have the same.
                let share = match skin.across(*face, *side) {
                    Across::Edge { .. } => 1.0,
                    _ => 1.0 / sides.len() as f64,
                };
                let along = skin.normals[*face];
                sum = add(sum, scale(along, share * bulge.unwrap_or(0.0)));
            }
            if sum != [0.0; 3] {
                bulges.insert(*edge, sum);
            }
        }
    }
    bulges
}

/// Volume between the smooth surface of a body and its facets over that of the body: positive where facets cut off more than
/// they add.
pub fn volume_beyond_facets(mesh: &Mesh, body: usize) -> f64 {
    let skin = Skin::new(mesh, body);
    // Over a facet the surface is the sum of a parabola each way.
    let over = |(index, face): (usize, &Face)| {
        let bulges = (0..4).filter_map(|side| skin.bulge(index, side));
        norm(face.area_vector(mesh)) / 3.0 * bulges.sum::<f64>()
    };
    let elements = mesh.bodies[body].elements.clone();
    let whole: f64 = elements.map(|element| volume(&mesh.corners(element))).sum();
    skin.faces.iter().enumerate().map(over).sum::<f64>() / whole
}

impl<'m> Skin<'m> {
    fn new(mesh: &'m Mesh, body: usize) -> Self {
        let faces = mesh.outer_faces(body);
        let mut at: HashMap<_, Vec<_>> = HashMap::new();
        for (index, face) in faces.iter().enumerate() {
            for side in 0..4 {
                at.entry(face.edge(side)).or_default().push((index, side));
            }
        }
        let normal = |face: &Face| unit(face.area_vector(mesh)).unwrap_or_default();
        Self {
            mesh,
            normals: faces.iter().map(normal).collect(),
            faces,
            at,
        }
    }

    fn across(&self, face: usize, side: usize) -> Across {
        let beside = self.at[&self.faces[face].edge(side)].as_slice();
        let [a, b] = beside else {
            return Across::Edge {
                leans: f64::INFINITY,
            };
        };
        let into = if a.0 == face { *b } else { *a };
        let [own, other] = [face, into.0].map(|f| self.normals[f]);
        let by = dot(own, other).clamp(-1.0, 1.0).acos();
        if by > MOST_TURN {
            return Across::Edge {
                leans: (by - FRAC_PI_2).abs(),
            };
        }
        if by < NO_TURN {
            return Across::Flat;
        }
        let [from, to] = [face, into.0].map(|f| self.faces[f].centre(self.mesh));
        let is_convex = dot(own, sub(to, from)) < 0.0;
        Across::Turns {
            by: if is_convex { by } else { -by },
            into,
        }
    }

    /// How the surface goes on beyond both ends of a side.
    fn ends(&self, face: usize, side: usize) -> [Across; 2] {
        [1, 3].map(|k| self.across(face, (side + k) % 4))
    }

    /// Is the surface flat along a side, as it goes on in the same plane at one end, or would as its own image beyond a plane
    /// of symmetry?
    fn is_straight(&self, face: usize, side: usize) -> bool {
        match self.ends(face, side) {
            [Across::Flat, _] | [_, Across::Flat] => true,
            [Across::Edge { leans }, Across::Turns { by, .. }]
            | [Across::Turns { by, .. }, Across::Edge { leans }] => leans < SQUARE * by.abs(),
            _ => false,
        }
    }

    /// How high the arc over a side of a facet is; `None` where nothing is known of it.
    fn bulge(&self, face: usize, side: usize) -> Option<f64> {
        if self.is_straight(face, side) {
            return Some(0.0);
        }
        let length = self.faces[face].sides(self.mesh)[side];
        let angle = |end: &Across| match *end {
            Across::Turns {
                by,
                into: (other, m),
            } => {
                let on = (m + 1) % 4;
                let beyond = self.faces[other].sides(self.mesh)[on];
                let share = if self.is_straight(other, on) {
                    1.0
                } else {
                    length / (length + beyond)
                };
                Some(share * by)
            }
            _ => None,
        };
        let angles: Vec<f64> = self.ends(face, side).iter().filter_map(angle).collect();
        // Where the surface ends at one side it is taken to go on as at the other.
        let mean =
            angles.iter().map(|angle| (0.5 * angle).tan()).sum::<f64>() / angles.len() as f64;
        (!angles.is_empty()).then_some(0.5 * length * mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, cylindrical, graded, uniform};

    /// A straight bar of the length 1 that goes on as a quarter of a ring of the radii 1 and 2, without names; `around` are
    /// the angles of its nodes. Split twice.
    fn bend(around: Vec<f64>) -> Mesh {
        let along = [0.0, 0.5]
            .into_iter()
            .chain(around.into_iter().map(|angle| 1.0 + angle));
        let block = Block::new(
            "bend",
            along.collect(),
            uniform(1.0, 2.0, 2),
            uniform(0.0, 1.0, 1),
        );
        let shape = |[s, r, z]: [f64; 3]| {
            let angle = (s - 1.0).max(0.0);
            [s.min(1.0) + r * angle.sin(), r * angle.cos(), z]
        };
        let mesh = block.mapped(shape).build().unwrap();
        let nameless = Mesh {
            surfaces: Vec::new(),
            ..mesh
        };
        nameless.split().unwrap().split().unwrap()
    }

    /// How far outer nodes are off the bar and the ring, all of them.
    fn off(mesh: &Mesh) -> f64 {
        let nodes = mesh.outer_faces(0).into_iter().flat_map(|face| face.nodes);
        let off = nodes.map(|node| {
            let [x, y, z] = mesh.points[node as usize];
            let r = y.hypot((x - 1.0).max(0.0));
            let of_ends = [x, y, z, z - 1.0].map(f64::abs);
            of_ends
                .into_iter()
                .chain([(r - 1.0).abs(), (r - 2.0).abs()])
                .fold(f64::INFINITY, f64::min)
        });
        off.fold(0.0, f64::max)
    }

    /// A ring of chords of the angle a has sin(a)/a of the section of the round one.
    #[test]
    fn the_volume_beyond_facets_is_that_of_the_round_body() {
        let parts = 12;
        let angles = uniform(0.0, FRAC_PI_2, parts);
        let block = Block::new("ring", uniform(1.0, 2.0, 2), angles, uniform(0.0, 1.0, 1));
        let mesh = block.mapped(cylindrical).build().unwrap();
        let angle = FRAC_PI_2 / parts as f64;
        let (found, wanted) = (volume_beyond_facets(&mesh, 0), angle / angle.sin() - 1.0);
        assert!((found / wanted - 1.0).abs() < 0.02, "{found} {wanted}");
    }

    #[test]
    fn arcs_over_the_chords_of_a_fillet_lie_on_it_and_its_plane_stays_flat() {
        assert!(off(&bend(uniform(0.0, FRAC_PI_2, 6))) < 1e-9);
    }

    #[test]
    fn a_flat_of_one_facet_that_ends_square_stays_flat() {
        let bar = Block::new(
            "bar",
            vec![0.0, 0.5, 0.6, 0.7, 0.8],
            uniform(-1.0, 0.0, 2),
            uniform(0.0, 1.0, 1),
        );
        let top = |x: f64| -0.5 * (x - 0.5).max(0.0).powi(2);
        let bar = bar.mapped(|[x, y, z]| [x, y + (1.0 + y) * top(x), z]);
        let nameless = Mesh {
            surfaces: Vec::new(),
            ..bar.build().unwrap()
        };
        let split = nameless.split().unwrap();
        let of_flat = split.points.iter().filter(|p| p[0] == 0.25 && p[1] > -0.2);
        assert!(
            of_flat.clone().count() == 3 && of_flat.clone().all(|p| p[1] == 0.0),
            "{of_flat:?}"
        );
    }

    #[test]
    fn arcs_over_chords_of_unlike_lengths_lie_near_the_circle() {
        let around = graded(0.0, FRAC_PI_2, 6, 1.2);
        let longest = around[6] - around[5];
        let sagitta = 2.0 * longest * longest / 8.0;
        let off = off(&bend(around));
        assert!(off < 0.05 * sagitta, "{off:.1e} of {sagitta:.1e}");
    }

    #[test]
    fn a_bar_with_six_sides_keeps_them() {
        let block = Block::new(
            "bar",
            uniform(0.5, 1.0, 1),
            uniform(0.0, 2.0 * FRAC_PI_2, 3),
            uniform(0.0, 1.0, 1),
        );
        let shape = |[r, angle, z]: [f64; 3]| [r * angle.cos(), r * angle.sin(), z];
        let mesh = block.mapped(shape).build().unwrap();
        assert!(bulges(&mesh, &HashSet::new()).is_empty());
    }
}
