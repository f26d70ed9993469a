//! The largest pressure of a contact interface.
//!
//! Where contact is a line, the load per length is known better than anything else ([`super::line`]). If the strip is
//! Hertz's, that load says how wide it is and how the pressure runs across; what the nodes make of such a profile can
//! then be worked out for the very places where they stand, and what they read beyond that is an error that one sees.

use super::contact::{COARSE, Contact, FILLET};
use super::figure::{Figure, Quantity};
use super::line::coarseness;
use crate::answer::results::edges::EVEN;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::hex::distance;
use crate::answer::results::strip_row::StripRow;
use crate::answer::results::tensor::traction;
use crate::ground::geometry::{add, dot, scale, sub, unit};
use crate::model::mesh::{Face, Surface};
use crate::model::scene::Scene;
use crate::model::state::ContactField;
use std::collections::BTreeSet;
use std::iter;

const EDGE: &str = "at a loaded edge: singular in elasticity, grows with every refinement";
const SHAPE: &str = "the facets there are too coarse for the shape of the surface, such as a fillet: the figure \
                     belongs to the mesh";

/// What a pressure that is read may be off beside its distance from Hertz's.
const READ: f64 = 0.006;
/// Error of the pressure for a node spacing of a, in the middle of the strip, and beyond that at its
/// edge; it falls with the square of the spacing. Measured on problem H with even and graded meshes.
const MIDDLE: f64 = 0.03;
const AT_EDGE: f64 = 0.25;
/// Share of the fall from the largest pressure to its neighbours that is its error: the mean over a hat
/// function takes a third of it off the peak of a smooth patch, and the mesh as much.
const FALL: f64 = 0.6;
/// Share of the distance between that pressure and the stress across the surface that is its error, at least, where contact
/// spreads from a point,
const OF_STRESS: f64 = 0.35;
/// and where sides are flat: their pressure is even where other bodies spread the load, and falls to no neighbour.
const OF_FLAT_STRESS: f64 = 0.5;
/// Sagitta of the facets at the peak over the length by which the pressure there presses a facet's depth
/// together: beyond this the shape, such as a fillet, is not there for the solution. Of a cylinder it is
/// the spacing over four half-widths.
const SHAPELESS: f64 = 0.5;

impl Contact<'_> {
    /// The largest pressure; where an edge decides it, the largest away from edges, too.
    pub(super) fn pressures(&self, field: &ContactField) -> Vec<Figure> {
        let Some(top) = self.largest(field, |_| true) else {
            return Vec::new();
        };
        let value = field.pressure[top];
        let at_edge =
            self.is_near_edge(field, top) && fall(self.scene, field, self.pair, top) > EVEN;
        let hides = self.edges.unseen_pressure(self.pair) > if at_edge { 0.0 } else { value };
        let why = match at_edge {
            _ if hides => FILLET,
            true => EDGE,
            false => return vec![self.pressure(Quantity::PeakPressure, field, top, self.line)],
        };
        let whole = Figure {
            at_edge,
            ..self.claim(Quantity::PeakPressure, value, None, why)
        };
        let line = self.line.map(|line| line.away().unwrap_or(line));
        let away = self.largest(field, |i| !self.is_near_edge(field, i));
        let away = away.map(|top| self.pressure(Quantity::PressureAway, field, top, line));
        iter::once(whole).chain(away).collect()
    }

    /// By how much the pressure rises, of itself, from a node to where a loaded edge beside it ceases to count, on the straight
    /// line to the nodes that are near to that edge.
    fn rise_to_edge(&self, field: &ContactField, top: usize) -> f64 {
        const HALVINGS: i32 = 20;
        let point = |i: usize| self.scene.mesh.points[field.nodes[i] as usize];
        let from = point(top);
        if self.edges.end_at(&from) {
            return 0.0;
        }
        let near = beside(self.scene, field, self.pair, top).into_iter();
        let near = near.filter(|i| self.is_near_edge(field, *i));
        let rise = |i: usize| {
            let towards = sub(point(i), from);
            let is_near = |share: f64| self.edges.are_near(&add(from, scale(towards, share)));
            let ceases = (1..=HALVINGS).fold(0.0, |far, k| {
                let next = far + 0.5f64.powi(k);
                if is_near(next) { far } else { next }
            });
            ceases * (field.pressure[i] / field.pressure[top] - 1.0)
        };
        near.map(rise).fold(0.0, f64::max)
    }

    /// The node with the largest pressure of those that press and count.
    fn largest(&self, field: &ContactField, counts: impl Fn(usize) -> bool) -> Option<usize> {
        let pressing = (0..field.nodes.len()).filter(|i| field.pressure[*i] > 0.0 && counts(*i));
        pressing.max_by(|a, b| field.pressure[*a].total_cmp(&field.pressure[*b]))
    }

    fn is_near_edge(&self, field: &ContactField, node: usize) -> bool {
        let at = &self.scene.mesh.points[field.nodes[node] as usize];
        self.edges.are_near(at)
    }

    /// The pressure of a node as the largest there is, on or beside a line.
    fn pressure(
        &self,
        what: Quantity,
        field: &ContactField,
        top: usize,
        line: Option<&HeaviestLine>,
    ) -> Figure {
        let value = field.pressure[top];
        if self.shapelessness(field, top) > SHAPELESS {
            return self.claim(what, value, None, SHAPE);
        }
        let fall = || FALL * fall(self.scene, field, self.pair, top);
        let by_stress = || {
            let share = if self.is_round {
                OF_STRESS
            } else {
                OF_FLAT_STRESS
            };
            fall().max(share * self.off_stress(field, top))
        };
        let error = line
            .filter(|line| line.is_long())
            .map_or_else(by_stress, |line| match (line.contact, line.departs) {
                // The pressure that the line load makes is known better than what few nodes read of it. That of many
                // is off by the second order of their distance, and is right where the bodies are no half spaces.
                (Some(hertz), None) => {
                    let coarse = coarseness(&line.line.heaviest);
                    let off = (hertz.peak_pressure / value - 1.0).abs();
                    coarse.powi(2) * off + coarse * READ + 0.5 * self.load_error(line)
                }
                (Some(hertz), Some(Departure::Flow)) => {
                    let a = line.line.heaviest.half_width.max(hertz.half_width);
                    of_nodes(&line.line.heaviest, a) + self.load_error(line)
                }
                (Some(_), Some(_)) => fall(),
                (None, _) => by_stress(),
            });
        // Where loads alternate from row to row, so do pressures.
        let alternates = line.map_or(0.0, |line| line.alternates);
        let error = error + self.rise_to_edge(field, top) + alternates;
        self.claim(what, value, Some(error), COARSE)
    }

    /// By how much the stress across the surfaces at a node differs from the pressure there, of that: of the carrier, or of the
    /// node of the other side next to it, whichever is more.
    fn off_stress(&self, field: &ContactField, node: usize) -> f64 {
        let mesh = &self.scene.mesh;
        let at = mesh.points[field.nodes[node] as usize];
        let off = |surface: &Surface| {
            let apart = |node: &u32| distance(mesh.points[*node as usize], at);
            let nodes = surface.faces.iter().flat_map(|face| face.nodes);
            let next = nodes.min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
            let beside = surface
                .faces
                .iter()
                .filter(|face| face.nodes.contains(&next));
            let sum = |sum, face: &Face| add(sum, face.area_vector(mesh));
            let normal = unit(beside.fold([0.0; 3], sum))?;
            let stress = self.recovered.nodal_stress.get(next as usize)?;
            let across = dot(normal, traction(stress, normal));
            Some((across / field.pressure[node] + 1.0).abs())
        };
        let sides = self.scene.contacts[self.pair].carrier_first();
        let surfaces = sides.into_iter().filter_map(|side| side.surface(mesh));
        surfaces.filter_map(off).fold(0.0, f64::max)
    }

    /// See [`SHAPELESS`]; at a node.
    fn shapelessness(&self, field: &ContactField, node: usize) -> f64 {
        let (scene, pair) = (self.scene, &self.scene.contacts[self.pair]);
        let (Some(surface), Ok(compliance)) = (scene.carrier(self.pair), scene.compliance(pair))
        else {
            return 0.0;
        };
        let faces = surface
            .faces
            .iter()
            .filter(|face| face.nodes.contains(&field.nodes[node]));
        let sides = faces.flat_map(|face| face.sides(&scene.mesh));
        let side = sides.fold(f64::INFINITY, f64::min);
        field.sagitta[node] / (compliance * field.pressure[node] * side)
    }
}

/// Relative error of the largest consistent pressure of a strip: what the mean over a hat function
/// takes off the peak, and what spacings that differ do.
fn of_nodes(row: &StripRow, a: f64) -> f64 {
    let [middle, edge] = [row.middle_spacing(), row.edge_spacing()].map(|h| (h / a).powi(2));
    let uneven = AT_EDGE * (edge - middle).max(0.0) + MIDDLE * middle;
    (1.0 - largest_mean(row, a)).hypot(uneven)
}

/// The largest mean of √(1 − x²/a²) over a node's hat function, as the nodes of the row stand.
fn largest_mean(row: &StripRow, a: f64) -> f64 {
    const POINTS: usize = 16;
    let profile = |x: f64| (1.0 - (x / a).powi(2)).max(0.0).sqrt();
    // From a node towards its neighbour: integrals of hat times profile, and of the hat.
    let half = |node: f64, next: f64| {
        let weights = (0..POINTS).map(|k| (k as f64 + 0.5) / POINTS as f64);
        let sum: f64 = weights
            .map(|t| (1.0 - t) * profile(node + t * (next - node)))
            .sum();
        let length = (next - node).abs();
        (sum * length / POINTS as f64, 0.5 * length)
    };
    let nodes = &row.nodes;
    let mean = |k: usize| {
        let (node, _) = nodes[k];
        let sides = [k.checked_sub(1), Some(k + 1)].into_iter().flatten();
        let halves = sides
            .filter_map(|n| nodes.get(n))
            .map(|(next, _)| half(node, *next));
        let (sum, weight) = halves.fold((0.0, 0.0), |s, h| (s.0 + h.0, s.1 + h.1));
        if weight > 0.0 { sum / weight } else { 0.0 }
    };
    (0..nodes.len())
        .map(mean)
        .fold(0.0, f64::max)
        .max(f64::MIN_POSITIVE)
}

/// By how much the pressures of the nodes beside `top` differ from its own, in the mean: what a peak falls by.
fn fall(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> f64 {
    if scene.carrier(pair).is_none() {
        return 1.0;
    }
    let through = |i: usize| scene.mirrors_through(&scene.mesh.points[field.nodes[i] as usize]);
    // A node off a mirror on which the peak lies stands for its image, too.
    let images = |i: usize| {
        let beside = through(top).filter(|axis| through(i).all(|own| own != *axis));
        beside.fold(1.0, |images, _| 2.0 * images)
    };
    let off = |i: usize| (1.0 - field.pressure[i] / field.pressure[top]).abs();
    let beside = beside(scene, field, pair, top).into_iter();
    let (sum, number) = beside.fold((0.0, 0.0), |(sum, number), i| {
        (sum + images(i) * off(i), number + images(i))
    });
    if number > 0.0 { sum / number } else { 0.0 }
}

/// The nodes that an edge of a face joins to `node`.
fn beside(scene: &Scene, field: &ContactField, pair: usize, node: usize) -> Vec<usize> {
    let node = field.nodes[node];
    let mut beside = BTreeSet::new();
    for face in scene
        .carrier(pair)
        .iter()
        .flat_map(|surface| &surface.faces)
    {
        for side in 0..4 {
            match [face.nodes[side], face.nodes[(side + 1) % 4]] {
                [a, b] if a == node => beside.insert(b),
                [a, b] if b == node => beside.insert(a),
                _ => false,
            };
        }
    }
    let index = |n: &u32| field.nodes.binary_search(n).ok();
    beside.iter().filter_map(index).collect()
}
