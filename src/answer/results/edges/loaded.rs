//! Loaded edges of contact surfaces, where elastic stresses are singular.
//!
//! A contact surface that ends while it still carries pressure, such as the end of a square
//! roller, has no finite elastic stress there: a peak beside it grows with every refinement until
//! plasticity bounds it.

use std::collections::{BTreeMap, BTreeSet};

use super::super::fillet;
use super::super::hex::distance;
use super::super::own_directions::first_side;
use super::boundary::{boundary, longest_side};
use super::reach::EdgeNodes;
use super::wedges::off_segment;
use crate::ground::geometry::Vec3;
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::{ContactPair, EDGE_REACH, Scene};
use crate::model::state::State;

/// The loaded edges of a state. A fillet that the mesh does not resolve is one, too.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadedEdges {
    nodes: EdgeNodes,
    /// Of each contact pair the largest pressure that may be at a fillet and that the mesh does not show;
    /// zero where there is none.
    unseen: Vec<f64>,
    /// Bodies that such an edge presses heavily, as its own or that of the other side.
    pressed: BTreeSet<usize>,
}

/// A pressure that varies by less from an edge is even, as between blocks of one size, and no singularity.
pub const EVEN: f64 = 0.02;

/// Of the largest pressure, above which the stress at an edge may be the largest: it is up to that pressure there, below a strip
/// 0.56 times it.
const HEAVY: f64 = 1.0 / 3.0;

impl LoadedEdges {
    /// Finds the loaded edges of every contact pair; edges on mirror planes, and on flat ends that
    /// are held as by a mirror, are none.
    pub fn find(scene: &Scene, state: &State) -> Self {
        let mut edges = Self {
            unseen: vec![0.0; state.contacts.len()],
            ..Self::default()
        };
        for (pair, field) in state.contacts.iter().enumerate() {
            let Some(surface) = scene.carrier(pair) else {
                continue;
            };
            if !(0..field.nodes.len()).any(|i| field.is_active(i)) {
                continue;
            }
            let of = |node: &u32| {
                let at = field.nodes.binary_search(node).ok()?;
                field.is_active(at).then(|| field.pressure[at])
            };
            let [_, other] = scene.contacts[pair].carrier_first();
            let other = other.surface(&scene.mesh);
            let extents = [Some(surface), other].into_iter().flatten();
            let extents =
                extents.map(|surface| longest_side(scene, &surface.nodes(), first_side(surface)));
            let whole = EDGE_REACH * extents.fold(f64::INFINITY, f64::min);
            let most = field.pressure.iter().copied().fold(0.0, f64::max);
            edges.add(scene, (pair, surface), (whole, most), |nodes| {
                largest(nodes.iter().filter_map(of))
            });
            // Where the other surface ends or begins to curve, the carrier may go on.
            if let Some(other) = other {
                let pressed = Pressed::new(scene, surface, of);
                edges.add(scene, (pair, other), (whole, most), |nodes| {
                    pressed.at(&scene.mesh, nodes)
                });
            }
        }
        edges
    }

    /// Adds the sides of faces under pressure that are on the boundary of a surface, or where a fillet begins
    /// that is not resolved.
    fn add(
        &mut self,
        scene: &Scene,
        (pair, surface): (usize, &Surface),
        (whole, most): (f64, f64),
        pressure: impl Fn(&[u32]) -> Option<f64>,
    ) {
        let mesh = &scene.mesh;
        let compliance = scene.compliance(&scene.contacts[pair]).unwrap_or(0.0);
        let ends_at = boundary(scene, surface);
        let fillets = fillet::beginnings(mesh, surface);
        for face in &surface.faces {
            for k in 0..4 {
                let side = face.edge(k);
                let bend = fillets.get(&side);
                // At the last node that presses a part of the pressure is lost.
                let unseen =
                    bend.and_then(|bend| fillet::unseen(*bend, pressure(&face.nodes)?, compliance));
                let is_loaded = || ends_at.contains(&side) && pressure(&side).is_some();
                if unseen.is_none() && !is_loaded() {
                    continue;
                }
                self.unseen[pair] = self.unseen[pair].max(unseen.unwrap_or(0.0));
                self.nodes.add(mesh, face, k, whole);
                let inner = face.edge(k + 2);
                let at_edge = pressure(&side).unwrap_or(0.0);
                let varies = (at_edge / pressure(&inner).unwrap_or(0.0) - 1.0).abs() > EVEN;
                if unseen.is_none() && varies && at_edge > HEAVY * most {
                    let bodies = scene.contacts[pair].bodies(mesh);
                    self.pressed.extend(bodies.into_iter().flatten());
                }
            }
        }
    }

    /// The largest pressure that a fillet may cause in a contact pair and that the mesh does not show; zero where
    /// there is none.
    pub fn unseen_pressure(&self, pair: usize) -> f64 {
        self.unseen.get(pair).copied().unwrap_or(0.0)
    }

    /// The Mises stress below such pressures in the body with that index: more than below a strip, less than
    /// below a sphere (Johnson, Contact Mechanics, sections 3.4 and 4.2).
    pub fn unseen_mises(&self, scene: &Scene, body: usize) -> f64 {
        const BELOW: f64 = 0.6;
        let on_body = |pair: &ContactPair| pair.bodies(&scene.mesh).contains(&Some(body));
        let pairs = scene.contacts.iter().enumerate();
        let pressures = pairs
            .filter(|(_, pair)| on_body(pair))
            .map(|(pair, _)| self.unseen_pressure(pair));
        BELOW * pressures.fold(0.0, f64::max)
    }

    /// Is the body with that index pressed heavily by a loaded edge, its own or that of another one?
    pub fn press(&self, body: usize) -> bool {
        self.pressed.contains(&body)
    }

    /// Does no contact surface end while it carries pressure?
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Is a point so near to a loaded edge that its stress belongs to the edge?
    ///
    /// The edge may be that of the other body: its end presses a singularity into this one too.
    pub fn are_near(&self, at: &[f64; 3]) -> bool {
        self.nodes.are_near(at)
    }

    /// Is a point so near to a loaded edge whose faces are longer than its stress reaches that it belongs to these?
    pub fn are_coarsely_near(&self, at: &[f64; 3]) -> bool {
        self.nodes.are_coarsely_near(at)
    }

    /// Does a loaded edge cease to reach just there? Meshes of the templates have nodes at such places.
    pub fn end_at(&self, at: &[f64; 3]) -> bool {
        self.nodes.end_at(at)
    }
}

/// The carrier's nodes in contact, how far each reaches, which is half of the diagonal of the faces around it, and their pressures.
struct Pressed(Vec<(Vec3, f64, f64)>);

impl Pressed {
    fn new(scene: &Scene, surface: &Surface, pressure: impl Fn(&u32) -> Option<f64>) -> Self {
        let mut boxes: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
        for face in &surface.faces {
            let corners = face.corners(&scene.mesh);
            let size = 0.5 * distance(corners[0], corners[2]);
            for node in &face.nodes {
                let Some(pressure) = pressure(node) else {
                    continue;
                };
                let known = boxes.entry(*node).or_insert((0.0, pressure));
                known.0 = known.0.max(size);
            }
        }
        let point = |node: u32| scene.mesh.points[node as usize];
        let boxes = boxes.into_iter();
        Self(
            boxes
                .map(|(node, (size, p))| (point(node), size, p))
                .collect(),
        )
    }

    /// The largest pressure of those that reach a side of a face, or one of the sides of a whole face.
    fn at(&self, mesh: &Mesh, nodes: &[u32]) -> Option<f64> {
        let point = |k: usize| mesh.points[nodes[k % nodes.len()] as usize];
        let apart = |at: &Vec3| {
            let sides = (0..nodes.len()).map(|k| off_segment(*at, point(k), point(k + 1)));
            sides.fold(f64::INFINITY, f64::min)
        };
        let reaches = |(at, size, _): &&(Vec3, f64, f64)| apart(at) <= (1.0 + ROUNDING) * size;
        largest(self.0.iter().filter(reaches).map(|(_, _, p)| *p))
    }
}

/// Share of a distance by which rounding may change it.
const ROUNDING: f64 = 1e-6;

fn largest(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(f64::max)
}
