//! What the neighbours of a node say of the stress there: how far averages of extrapolated stresses are above it, and
//! how much higher it is beside the node.
//!
//! Stresses of trilinear elements are right at integration points. Along one direction a straight line through two of
//! these, of an element as long as h, is above a stress of the second derivative f'' by -f'' h²/12 at the ends of the
//! element. So are averages at nodes, below a peak above it. The second derivative is that of the averages themselves.

use super::recovery::{Recovered, mirrored};
use super::tensor::mises;
use crate::ground::geometry::{Vec3, dot, norm, sub};
use crate::model::mesh::hexahedron::NEIGHBOURS;
use crate::model::scene::Scene;
use std::collections::BTreeMap;

/// Cosine of the angle from which on two neighbours are no longer opposite of each other.
const OPPOSITE: f64 = -0.7;

/// What is between a nodal Mises stress and the stress itself, both without sign; zero where nothing is known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Curvature {
    /// By how much extrapolation to the node is above the stress there, or below it where that is negative.
    pub overshoot: f64,
    /// By how much the vertex of the parabolas through a largest value and its neighbours is above it.
    pub vertex: f64,
}

/// Two neighbours of a node on opposite sides.
struct Line {
    stress: [[f64; 6]; 2],
    length: [f64; 2],
}

/// Curvature of the stress at a node of a body; `elements` are its elements there, and which corner the node is.
/// Neighbours that `is_beside` a loaded edge say nothing: the stress is singular there.
pub(super) fn curvature(
    scene: &Scene,
    recovered: &Recovered,
    elements: &[(usize, usize)],
    is_beside: impl Fn(&Vec3) -> bool,
) -> Curvature {
    let Some((element, corner)) = elements.first() else {
        return Curvature::default();
    };
    let point = recovered.points.cells[*element][*corner];
    let own = recovered.nodal_stress[point as usize];
    let mut stress = own;
    let mut vertex = 0.0;
    for line in lines(scene, recovered, (point, elements), is_beside) {
        let share = line.length.iter().map(|h| h * h).sum::<f64>() / 24.0;
        for (k, component) in stress.iter_mut().enumerate() {
            let [_, second] = line.derivatives(own[k], line.stress.map(|s| s[k]));
            *component += share * second;
        }
        let (peak, beside) = (mises(&own), line.stress.map(|s| mises(&s)));
        let [slope, second] = line.derivatives(peak, beside);
        if second < 0.0 && beside.iter().all(|value| *value <= peak) {
            vertex += slope * slope / (-2.0 * second);
        }
    }
    Curvature {
        overshoot: mises(&own) - mises(&stress),
        vertex,
    }
}

/// The lines through a point from neighbour to neighbour, straight but for a little. On a mirror plane a neighbour off the
/// plane has its own image as opposite.
fn lines(
    scene: &Scene,
    recovered: &Recovered,
    (point, elements): (u32, &[(usize, usize)]),
    is_beside: impl Fn(&Vec3) -> bool,
) -> Vec<Line> {
    let points = &recovered.points;
    let at = |point: u32| scene.mesh.points[points.node[point as usize] as usize];
    let centre = at(point);
    // Neighbours, and those that they share an element with.
    let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (element, corner) in elements {
        let three = NEIGHBOURS[*corner].map(|c| points.cells[*element][c]);
        for neighbour in three {
            neighbours.entry(neighbour).or_default().extend(three);
        }
    }
    let towards = |point: u32| sub(at(point), centre);
    let mirror = |neighbour: u32| {
        let to = towards(neighbour);
        let mut mirrors = scene.mirrors_through(&centre);
        mirrors.find(|axis| to[*axis].abs() > -OPPOSITE * norm(to))
    };
    let opposite = |neighbour: u32, with: &[u32]| {
        let mut others = neighbours.keys().filter(|other| !with.contains(other));
        let (only, more) = (others.next()?, others.next());
        let (a, b) = (towards(neighbour), towards(*only));
        let straight = dot(a, b) <= OPPOSITE * norm(a) * norm(b);
        // Each pair once.
        (more.is_none() && straight && neighbour < *only).then_some(*only)
    };
    let stress = |point: u32| recovered.nodal_stress[point as usize];
    let line = |(neighbour, with): (&u32, &Vec<u32>)| {
        let own = stress(*neighbour);
        let (other, image) = match mirror(*neighbour) {
            Some(axis) => (*neighbour, mirrored(own, axis)),
            None => {
                let other = opposite(*neighbour, with)?;
                (other, stress(other))
            }
        };
        let both = [*neighbour, other];
        let counts = both.iter().all(|point| !is_beside(&at(*point)));
        counts.then(|| Line {
            stress: [own, image],
            length: both.map(|point| norm(towards(point))),
        })
    };
    neighbours.iter().filter_map(line).collect()
}

impl Line {
    /// First and second derivative along the line at its middle, of values there and at both ends.
    fn derivatives(&self, middle: f64, ends: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.length;
        let (to, from) = ((ends[0] - middle) / a, (middle - ends[1]) / b);
        [(to * b + from * a) / (a + b), 2.0 * (to - from) / (a + b)]
    }
}
