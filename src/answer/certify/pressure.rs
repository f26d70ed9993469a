//! Pressure, line load and width of a contact interface.
//!
//! Where contact is a line, the load per length is known better than anything else, for it follows
//! from balance. If the strip is Hertz's, that load says how wide it is and how the pressure runs
//! across; what the nodes make of such a profile can then be worked out for the very places where they
//! stand, and what they read beyond that is an error that one sees.

use super::figure::{Errors, Figure, Quantity, figure_of};
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::{Departure, HeaviestLine};
use crate::answer::results::interface::Interface;
use crate::answer::results::load::{cutting_pair, times};
use crate::answer::results::strip_row::StripRow;
use crate::ground::geometry::{norm, sub};
use crate::model::scene::Scene;
use crate::model::state::{ContactField, State};
use std::collections::BTreeSet;
use std::iter;

const COARSE: &str = "the nodes are too far apart for the strip or patch of contact: the figure belongs to \
                      the mesh";
const EDGE: &str = "at a loaded edge: singular in elasticity, grows with every refinement";
const MERGED: &str = "the strip is wider or narrower than its load makes it: lines that the mesh does not tell \
                      apart, or a shape that is no line";
const FILLET: &str = "the facets are too long for a fillet under load: where it begins the pressure may have a higher \
                      and narrow peak";
const SHAPE: &str = "the facets there are too coarse for the shape of the surface, such as a fillet: the figure \
                     belongs to the mesh";

/// Beyond this relative error a figure is not resolved.
const WORTHLESS: f64 = 0.3;

/// A load per length is this good at best: far field, and rows along the line. Half a per cent in the median
/// of bearings drawn by a seed, two in one of ten.
const LINE_LOAD: f64 = 0.014;
/// What a strip that the mesh is too coarse for moves of it along the line and to the line beside it, for each
/// power of e by which the spacing exceeds [`WELL`] of the half-width: bodies come too close below it by such a
/// logarithm (Johnson, Contact Mechanics, section 5.6). On single bearings 0.02 to 0.05; with this, line loads on `h025` err by
/// at most 0.75 to 0.94 of their bars in 95 of 100 cases of three seeds.
const UNSEEN: f64 = 0.025;
/// Spacing over half-width up to which that is nothing.
const WELL: f64 = 0.67;
/// Beside a loaded edge, in addition.
const BESIDE_EDGE: f64 = 0.02;
/// Share of the kink at the peak of a line load that is its error,
const KINK: f64 = 0.2;
/// and beside a loaded edge, where loads rise with a power of the distance and the last rows of the mesh cut that off.
const KINK_AT_EDGE: f64 = 0.5;
/// Share of what rows elsewhere on a line hide that the error of its largest load is at least. Where loads alternate from row
/// to row, the largest may be another one (docs/coverage.md).
const HIDDEN: f64 = 0.3;
/// What a pressure that is read may be off beside its distance from Hertz's.
const READ: f64 = 0.006;
/// The same of a half-width, for a spacing of a at the edge; it falls with the square of the spacing.
const WIDTH: f64 = 0.03;
/// Error of the pressure for a node spacing of a, in the middle of the strip, and beyond that at its
/// edge; it falls with the square of the spacing. Measured on problem H with even and graded meshes.
const MIDDLE: f64 = 0.03;
const AT_EDGE: f64 = 0.25;
/// Share of the fall from the largest pressure to its neighbours that is its error: the mean over a hat
/// function takes a third of it off the peak of a smooth patch, and the mesh as much.
const FALL: f64 = 0.6;
/// A pressure that falls by less from an edge is even, as between blocks of one size, and no singularity.
const EVEN: f64 = 0.02;
/// Sagitta of the facets at the peak over the length by which the pressure there presses a facet's depth
/// together: beyond this the shape, such as a fillet, is not there for the solution. Of a cylinder it is
/// the spacing over four half-widths.
const SHAPELESS: f64 = 0.5;
/// Of the area of the nodes at the rim, on both sides of it: the true rim lies anywhere between them.
const RIM: f64 = 0.27;

/// What is known of an interface.
pub(super) struct Contact<'a> {
    pub scene: &'a Scene,
    pub state: &'a State,
    pub pair: usize,
    pub interface: &'a Interface,
    pub line: Option<&'a HeaviestLine>,
    pub edges: &'a LoadedEdges,
}

impl Contact<'_> {
    /// Peak pressure, Hertz's pressure, largest line load, half-width, area and length.
    pub(super) fn claims(&self) -> Vec<Figure> {
        let Some(field) = self.state.contacts.get(self.pair) else {
            return Vec::new();
        };
        if self.interface.max_pressure <= 0.0 {
            return Vec::new();
        }
        let mut claims = self.pressures(field);
        if let Some(line) = self.line {
            claims.extend(self.along(line));
            claims.push(self.length(line));
            claims.extend(self.hertz_pressure(line));
        }
        let copies = times(&cutting_pair(self.scene, self.pair));
        let band = RIM * copies * rim(self.scene, field, self.pair);
        let area = self.interface.area;
        claims.push(self.claim(Quantity::ContactArea, area, Some(band / area), COARSE));
        claims
    }

    /// With a relative error, where that says anything.
    fn claim(&self, what: Quantity, value: f64, error: Option<f64>, why: &'static str) -> Figure {
        // The rim of an area is never known better than to an element.
        let most = if what == Quantity::ContactArea {
            0.5
        } else {
            WORTHLESS
        };
        let error = error.filter(|e| e.is_finite() && *e <= most);
        Figure {
            error: Errors {
                discretisation: error.map(|e| e * value),
                ..Errors::default()
            },
            note: error.is_none().then_some(why),
            ..figure_of(what, &self.interface.name, value)
        }
    }

    /// The largest pressure; where an edge decides it, the largest away from edges, too.
    fn pressures(&self, field: &ContactField) -> Vec<Figure> {
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
        let line = self.line.and_then(HeaviestLine::away);
        let away = self.largest(field, |i| !self.is_near_edge(field, i));
        let away = away.map(|top| self.pressure(Quantity::PressureAway, field, top, line));
        iter::once(whole).chain(away).collect()
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
        let error = line
            .filter(|line| line.is_long())
            .map_or_else(fall, |line| match (line.contact, line.departs) {
                // The pressure that the line load makes is known better than what few nodes read of it. That of many
                // is off by the second order of their distance, and is right where the bodies are no half spaces.
                (Some(hertz), None) => {
                    let coarse = coarseness(&line.line.heaviest);
                    let off = (hertz.peak_pressure / value - 1.0).abs();
                    coarse.powi(2) * off + coarse * READ + 0.5 * load_error(line)
                }
                (Some(hertz), Some(Departure::Flow)) => {
                    let a = line.line.heaviest.half_width.max(hertz.half_width);
                    of_nodes(&line.line.heaviest, a) + load_error(line)
                }
                _ => fall(),
            });
        self.claim(what, value, Some(error), COARSE)
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
        let sides = faces.flat_map(|face| {
            let corners = face.corners(&scene.mesh);
            [0, 1, 2, 3].map(|k| norm(sub(corners[k], corners[(k + 1) % 4])))
        });
        let side = sides.fold(f64::INFINITY, f64::min);
        field.sagitta[node] / (compliance * field.pressure[node] * side)
    }

    /// Of the line that carries most; where a fillet that the mesh hides decides that, away from it, too.
    fn along(&self, line: &HeaviestLine) -> Vec<Figure> {
        let own = [
            self.line_load(Quantity::LineLoad, line),
            self.half_width(Quantity::HalfWidth, line),
        ];
        let away = line.away().filter(|_| self.hides_load(line));
        let away = away.map(|line| {
            [
                self.line_load(Quantity::LineLoadAway, line),
                self.half_width(Quantity::HalfWidthAway, line),
            ]
        });
        own.into_iter().chain(away.into_iter().flatten()).collect()
    }

    /// Where the mesh hides what presses there it hides what that carries, too.
    fn hides_load(&self, line: &HeaviestLine) -> bool {
        line.departs == Some(Departure::LoadedEdge) && self.edges.unseen_pressure(self.pair) > 0.0
    }

    fn line_load(&self, what: Quantity, line: &HeaviestLine) -> Figure {
        let at_edge = line.departs == Some(Departure::LoadedEdge);
        let (error, why) = match line.departs {
            Some(Departure::Width) => (None, MERGED),
            _ if self.hides_load(line) => (None, FILLET),
            _ => (Some(load_error(line)), COARSE),
        };
        Figure {
            at_edge,
            ..self.claim(what, line.line_load, error, why)
        }
    }

    /// `None` where the strip is not Hertz's.
    fn hertz_pressure(&self, line: &HeaviestLine) -> Option<Figure> {
        let value = line.pressure()?;
        Some(self.claim(
            Quantity::HertzPressure,
            value,
            Some(0.5 * load_error(line)),
            COARSE,
        ))
    }

    fn half_width(&self, what: Quantity, line: &HeaviestLine) -> Figure {
        let row = &line.line.heaviest;
        let a = row.half_width;
        let edge = row.edge_spacing() / a;
        let hertz = line.contact.filter(|_| line.is_long());
        let error = match (hertz, line.departs) {
            (Some(hertz), None | Some(Departure::LoadedEdge)) => {
                let spacing = WIDTH * edge * edge;
                Some((hertz.half_width / a - 1.0).abs() + spacing + 0.5 * load_error(line))
            }
            (Some(_), Some(Departure::Width)) => None,
            _ => Some(0.5 * edge * edge + load_error(line)),
        };
        self.claim(what, a, error, MERGED)
    }

    /// Where a line lifts off, the place lies between two rows, or beyond the next one: loads near it are small.
    fn length(&self, line: &HeaviestLine) -> Figure {
        let unseen = if line.line.lifted_off > 0.0 {
            unseen(line)
        } else {
            0.0
        };
        let line = &line.line;
        let rows = line.at.windows(2).zip(line.load.windows(2));
        let lifts = rows.filter(|(_, q)| (q[0] > 0.0) != (q[1] > 0.0));
        let off: f64 = lifts.map(|(at, _)| at[1] - at[0]).sum();
        let images = if line.length > 0.0 {
            line.length_share()
        } else {
            1.0
        };
        self.claim(
            Quantity::ContactLength,
            line.length,
            Some(images * off / line.length + unseen + 1e-6),
            COARSE,
        )
    }
}

/// What a mesh this fine leaves of errors that do not fall with the square of its spacing: all of them down to
/// three nodes in a half-width.
fn coarseness(row: &StripRow) -> f64 {
    const FINE: f64 = 3.0;
    (FINE * row.spacing() / row.half_width).min(1.0)
}

/// Relative error of the largest load per length; Hertz's pressure and half-width go with its root.
fn load_error(line: &HeaviestLine) -> f64 {
    let edge = match line.departs {
        Some(Departure::LoadedEdge) => BESIDE_EDGE + KINK_AT_EDGE * line.kink,
        _ => KINK * line.kink,
    };
    let own = coarseness(&line.line.heaviest) * LINE_LOAD + unseen(line) + edge;
    own.max(HIDDEN * line.hidden)
}

/// See [`UNSEEN`].
fn unseen(line: &HeaviestLine) -> f64 {
    let row = &line.line.heaviest;
    let a = (line.contact).map_or(row.half_width, |hertz| hertz.half_width);
    UNSEEN * (row.middle_spacing() / (WELL * a)).ln().max(0.0)
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

/// By how much the pressure falls from a peak at `top` to the neighbours of that node, in the mean.
fn fall(scene: &Scene, field: &ContactField, pair: usize, top: usize) -> f64 {
    let Some(surface) = scene.carrier(pair) else {
        return 1.0;
    };
    let node = field.nodes[top];
    let mut beside = BTreeSet::new();
    for face in &surface.faces {
        for side in 0..4 {
            match [face.nodes[side], face.nodes[(side + 1) % 4]] {
                [a, b] if a == node => beside.insert(b),
                [a, b] if b == node => beside.insert(a),
                _ => false,
            };
        }
    }
    let values = beside
        .iter()
        .filter_map(|n| field.nodes.binary_search(n).ok());
    let values: Vec<f64> = values.map(|i| field.pressure[i]).collect();
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    1.0 - mean / field.pressure[top]
}

/// Area of the nodes in contact next to one that is not, and of those, modelled part.
fn rim(scene: &Scene, field: &ContactField, pair: usize) -> f64 {
    let Some(surface) = scene.carrier(pair) else {
        return 0.0;
    };
    let index = |node: u32| field.nodes.binary_search(&node).ok();
    let mut rim = BTreeSet::new();
    for face in &surface.faces {
        for side in 0..4 {
            let ends = [face.nodes[side], face.nodes[(side + 1) % 4]].map(index);
            let [Some(a), Some(b)] = ends else { continue };
            if field.is_active(a) != field.is_active(b) {
                rim.extend([a, b]);
            }
        }
    }
    rim.iter().map(|i| field.area[*i]).sum()
}
