//! The largest pressure of a contact interface.
//!
//! Where contact is a line, the load per length is known better than anything else ([`super::line`]). If the strip is
//! Hertz's, that load says how wide it is and how the pressure runs across; what the nodes make of such a profile can
//! then be worked out for the very places where they stand, and what they read beyond that is an error that one sees.

use super::contact::{Contact, Touch};
use super::fall::{beside, fall};
use super::figure::{Figure, Quantity};
use super::line::coarseness;
use super::notes::{COARSE, FILLET, LONG_FACES, SHAPE};
use super::rim::{Rim, mean};
use super::scatter;
use crate::answer::results::edges::EVEN;
use crate::answer::results::first_layer::first_layer;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::hex::distance;
use crate::answer::results::strip_row::StripRow;
use crate::answer::results::tensor::traction;
use crate::ground::geometry::{Vec3, add, dot, scale, sub, unit};
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::Partner;
use crate::model::state::ContactField;
use std::iter;

const EDGE: &str = "at a loaded edge: singular in elasticity, grows with every refinement";

const TIE: &str = "beside a tie that the contact crosses: nodes that follow carry no pressure, those beside them more than theirs";

/// What a pressure that is read may be off beside its distance from Hertz's.
const READ: f64 = 0.006;
/// Error of the pressure for a node spacing of a, in the middle of the strip, and beyond that at its edge, or at the rim of a
/// point of contact; it falls with the square of the spacing. Measured on problem H with even and graded meshes. (Of 292
/// pressures of spheres and crowned faces on meshes drawn at random, even and graded, 74 were outside without the second, 7 with it.)
const MIDDLE: f64 = 0.03;
const AT_EDGE: f64 = 0.25;
/// Share of the fall from the largest pressure to its neighbours that is its error: the mean over a hat
/// function takes a third of it off the peak of a smooth patch, and the mesh as much.
const FALL: f64 = 0.6;
/// Share of the distance between that pressure and the stress across the surface that is its error, at least, where a side
/// curves,
const OF_STRESS: f64 = 0.35;
/// and where sides are flat, or curve alike: their pressure is even where other bodies spread the load, and falls to no neighbour.
const OF_FLAT_STRESS: f64 = 0.5;
/// Share of the square of the distance from the stress across the surface: that falls with the spacing, the error with its
/// square.
const OF_STRESS_SQUARED: f64 = 2.0;
/// Share of its third power below a strip that flows: coarse meshes press as if less did. (Of 67 such strips, whose pressures fall to
/// 0.68 of Hertz's, 7 were outside without it, 3 of 61 with it.)
const OF_STRESS_IN_FLOW: f64 = 10.0;
/// Of the scatter of the pressures beside the peak about a smooth one that is its error: where faces are no grid, each node has an
/// error of its own. (Of 299 largest pressures of spheres and cylinders on unstructured meshes, drawn by two seeds, 137 were outside
/// without it, 12 with it; of 134 on grids none.)
const SCATTER: f64 = 1.4;
/// Of how much pressures differ from those beside them, all over an interface, what is missing where they are even: their sum is
/// that of the load.
const ELSEWHERE: f64 = 1.5;
/// Sagitta of the facets at the peak over the length by which the pressure there presses a facet's depth
/// together: beyond this the shape, such as a fillet, is not there for the solution. Of a cylinder it is
/// the spacing over four half-widths.
const SHAPELESS: f64 = 0.5;
/// Depth over half-width from which on elements below a strip, however fine along its surface, say no more of its pressure than few do
/// across it, as its inverse. (First layers of 0.6, 1.9 and 3.1 half-widths below nodes a tenth of one apart: 1.5, 10 and 22 % too much, with bars of 0.5, 1.6
/// and 0.1 % without it.)
const DEEP: f64 = 1.5;

impl Contact<'_> {
    /// The largest pressure; where an edge decides it, the largest away from edges, too.
    pub(super) fn pressures(&self, field: &ContactField) -> Vec<Figure> {
        let Some(top) = self.largest(field, |_| true) else {
            return Vec::new();
        };
        let value = field.pressure[top];
        if self.is_beside_tie(field, top) {
            return vec![self.claim(Quantity::PeakPressure, value, None, TIE)];
        }
        let at_edge =
            self.is_near_edge(field, top) && fall(self.scene, field, self.pair, top).mean > EVEN;
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

    /// Does a node of either side that follows a tie lie within two faces of a node of the carrier?
    fn is_beside_tie(&self, field: &ContactField, node: usize) -> bool {
        const FACES: f64 = 2.0;
        let point = |node: u32| self.scene.mesh.points[node as usize];
        let at = point(field.nodes[node]);
        let reach = FACES * self.sides_around(field, node).fold(0.0, f64::max);
        let follow = self.state.ties.iter().flat_map(|tie| &tie.nodes);
        let mut near = follow.filter(|n| distance(point(**n), at) <= reach);
        let sides = self.scene.contacts[self.pair].carrier_first();
        let surfaces = sides.map(|side| side.surface(&self.scene.mesh));
        near.any(|node| {
            let faces = surfaces.iter().flatten().flat_map(|surface| &surface.faces);
            faces.into_iter().any(|face| face.nodes.contains(node))
        })
    }

    /// Lengths of the sides of the carrier's faces around a node.
    fn sides_around(&self, field: &ContactField, node: usize) -> impl Iterator<Item = f64> {
        let faces = self.scene.carrier(self.pair).into_iter();
        let faces = faces.flat_map(|surface| &surface.faces);
        let around = faces.filter(move |face| face.nodes.contains(&field.nodes[node]));
        around.flat_map(|face| face.sides(&self.scene.mesh))
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

    /// By how much a loaded edge whose faces are longer than its stress reaches presses more than a node that is away from it, of that: the
    /// pressure where the stress of the edge ceases lies within these faces, and between both.
    fn rise_in_long_faces(&self, field: &ContactField, node: usize) -> f64 {
        let at = |i: usize| &self.scene.mesh.points[field.nodes[i] as usize];
        let at_edge = self.largest(field, |i| self.edges.are_coarsely_near(at(i)));
        at_edge.map_or(0.0, |i| {
            (field.pressure[i] / field.pressure[node] - 1.0).max(0.0)
        })
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
        let long = line.filter(|line| line.is_long());
        // Of a point that is a matter of the spacing, and the fall tells.
        if self.touch != Touch::Point && self.shapelessness(field, top) > SHAPELESS {
            return self.claim(what, value, None, SHAPE);
        }
        // Of one node its area is read, and nothing of the patch.
        let presses = |i: &usize| field.is_active(*i);
        if long.is_none()
            && !beside(self.scene, field, self.pair, top)
                .iter()
                .any(presses)
        {
            return self.claim(what, value, None, COARSE);
        }
        let fall = || fall(self.scene, field, self.pair, top);
        let by_stress = || {
            let off = self.off_stress(field, top);
            match self.touch {
                Touch::Point => {
                    let cap = fall().of_cap().max(OF_STRESS_SQUARED * off.powi(2));
                    cap + AT_EDGE * self.grows_to_rim(field, top)
                }
                Touch::Line if !self.conforms() => (FALL * fall().mean).max(OF_STRESS * off),
                Touch::Line | Touch::Flat => {
                    let elsewhere = ELSEWHERE * scatter::mean(self.scene, field, self.pair) / value;
                    (FALL * fall().mean).max(OF_FLAT_STRESS * off) + elsewhere
                }
            }
        };
        let deep = |a: f64| (DEEP * self.depth(field, top) / a).min(1.0);
        let error = long.map_or_else(by_stress, |line| match (line.contact, line.departs) {
            // The pressure that the line load makes is known better than what few nodes read of it. That of many
            // is off by the second order of their distance, and is right where the bodies are no half spaces.
            (Some(hertz), None | Some(Departure::LoadedEdge | Departure::Kink)) => {
                let coarse = coarseness(&line.line.heaviest).max(deep(hertz.half_width));
                let off = (hertz.peak_pressure / value - 1.0).abs();
                let by_load = coarse.powi(2) * off + coarse * READ + 0.5 * self.load_error(line);
                match line.departs {
                    None => by_load,
                    // The load of the row may not be that of the node.
                    _ => by_load.max(FALL * fall().mean),
                }
            }
            (Some(hertz), Some(Departure::Flow)) => {
                let a = line.line.heaviest.half_width.max(hertz.half_width);
                // Flow only lowers the pressure that a load makes.
                let above = (value / hertz.peak_pressure - 1.0).max(0.0);
                let unseen = OF_STRESS_IN_FLOW * self.off_stress(field, top).powi(3);
                let read = of_nodes(&line.line.heaviest, a).hypot(unseen);
                above.max(read) + self.load_error(line)
            }
            (None, _) => by_stress(),
            (_, Some(departs)) if !departs.keeps_half_spaces() => by_stress(),
            // Deep elements make a strip narrower, and press more.
            (Some(hertz), Some(_)) => {
                let above = (1.0 - hertz.peak_pressure / value).max(0.0);
                (FALL * fall().mean).max(deep(hertz.half_width).powi(2) * above)
            }
        });
        // Where loads alternate from row to row, so do pressures.
        let alternates = line.map_or(0.0, |line| line.alternates);
        let scatter = scatter::about(self.scene, field, self.pair, top);
        let error = error.hypot(SCATTER * scatter)
            + self.rise_to_edge(field, top)
            + alternates
            + self.shared_otherwise()
            + self.linings_off;
        let rise = self.rise_in_long_faces(field, top);
        let why = if rise > error { LONG_FACES } else { COARSE };
        self.claim(what, value, Some(error.max(rise)), why)
    }

    /// By how much the stress across the surfaces at a node differs from the pressure there, of that: of the carrier, or of the
    /// node of the other side next to it, whichever is more.
    fn off_stress(&self, field: &ContactField, node: usize) -> f64 {
        let mesh = &self.scene.mesh;
        let at = mesh.points[field.nodes[node] as usize];
        let off = |surface: &Surface| {
            let next = nearest(mesh, surface, at)?;
            let normal = unit(surface.area_vector_at(mesh, next))?;
            let stress = self.recovered.nodal_stress.get(next as usize)?;
            let across = dot(normal, traction(stress, normal));
            Some((across / field.pressure[node] + 1.0).abs())
        };
        let sides = self.scene.contacts[self.pair].carrier_first();
        let surfaces = sides.into_iter().filter_map(|side| side.surface(mesh));
        surfaces.filter_map(off).fold(0.0, f64::max)
    }

    /// How deep the elements below a node and the one of the other side next to it are; the more of either, the more of what both yield is
    /// its own.
    fn depth(&self, field: &ContactField, node: usize) -> f64 {
        let (scene, pair) = (self.scene, &self.scene.contacts[self.pair]);
        let Ok(whole) = scene.compliance(pair) else {
            return 0.0;
        };
        let at = scene.mesh.points[field.nodes[node] as usize];
        let share = |side: &Partner| {
            let surface = side.surface(&scene.mesh)?;
            let depth = first_layer(scene, surface, nearest(&scene.mesh, surface, at)?)?;
            Some(scene.compliance_of(side).ok()? / whole * depth * depth)
        };
        let sides = [&pair.upper, &pair.lower].into_iter();
        sides.filter_map(share).sum::<f64>().sqrt()
    }

    /// By how much faces grow from the peak to the rim of a patch: the square of their length over the radius of the patch, at
    /// the rim, less that at the peak.
    fn grows_to_rim(&self, field: &ContactField, top: usize) -> f64 {
        let rim = Rim::around(self.scene, field, self.pair, top);
        let at_peak =
            mean(self.sides_around(field, top).map(|side| side * side)) / rim.squared_radius();
        (rim.squared_spacing(self.scene, self.pair) - at_peak).max(0.0)
    }

    /// See [`SHAPELESS`]; at a node.
    fn shapelessness(&self, field: &ContactField, node: usize) -> f64 {
        let (scene, pair) = (self.scene, &self.scene.contacts[self.pair]);
        let Ok(compliance) = scene.compliance(pair) else {
            return 0.0;
        };
        let side = self.sides_around(field, node).fold(f64::INFINITY, f64::min);
        field.sagitta[node] / (compliance * field.pressure[node] * side)
    }
}

/// The node of a surface next to a place.
fn nearest(mesh: &Mesh, surface: &Surface, at: Vec3) -> Option<u32> {
    let apart = |node: &u32| distance(mesh.points[*node as usize], at);
    let nodes = surface.faces.iter().flat_map(|face| face.nodes);
    nodes.min_by(|a, b| apart(a).total_cmp(&apart(b)))
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
