//! Loaded edges of contact surfaces, where elastic stresses are singular.
//!
//! A contact surface that ends while it still carries pressure, such as the end of a square
//! roller, has no finite elastic stress there: a peak beside it grows with every refinement until
//! plasticity bounds it.

use std::collections::BTreeMap;

use super::fillet;
use super::hex::distance;
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::{ContactPair, Scene};
use crate::model::state::State;

/// The loaded edges of a state. A fillet that the mesh does not resolve is one, too.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadedEdges {
    /// Nodes on boundaries of contact surfaces that are in contact, and how far the stress of the edge
    /// reaches: a fiftieth of the contact surface, and no less than the face there is long.
    nodes: Vec<([f64; 3], f64)>,
    /// Of each contact pair the largest pressure that may be at a fillet and that the mesh does not show;
    /// zero where there is none.
    unseen: Vec<f64>,
}

/// Of the size of a contact surface.
const REACH: f64 = 0.02;

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
            edges.add(scene, (pair, surface), |nodes| {
                largest(nodes.iter().filter_map(of))
            });
            // Where the other surface ends or begins to curve, the carrier may go on.
            let [_, other] = scene.contacts[pair].carrier_first();
            if let Some(other) = other.surface(&scene.mesh) {
                let pressed = Pressed::new(scene, surface, of);
                edges.add(scene, (pair, other), |nodes| pressed.at(&scene.mesh, nodes));
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
        pressure: impl Fn(&[u32]) -> Option<f64>,
    ) {
        let mesh = &scene.mesh;
        let compliance = scene.compliance(&scene.contacts[pair]).unwrap_or(0.0);
        let boundary = boundary_nodes(scene, surface);
        let on_boundary = |node: &u32| boundary.binary_search(node).is_ok();
        let fillets = fillet::beginnings(mesh, surface);
        let whole = REACH * whole_extent(scene, surface);
        for face in &surface.faces {
            for k in 0..4 {
                let side = [face.nodes[k], face.nodes[(k + 1) % 4]];
                let bend = fillets.get(&fillet::ends(face.nodes, k));
                // At the last node that presses a part of the pressure is lost.
                let unseen =
                    bend.and_then(|bend| fillet::unseen(*bend, pressure(&face.nodes)?, compliance));
                let is_loaded = || side.iter().all(on_boundary) && pressure(&side).is_some();
                if unseen.is_none() && !is_loaded() {
                    continue;
                }
                self.unseen[pair] = self.unseen[pair].max(unseen.unwrap_or(0.0));
                let corners = face.corners(mesh);
                let reach = distance(corners[0], corners[2]).max(whole);
                self.nodes
                    .extend(side.map(|n| (mesh.points[n as usize], reach)));
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
        let on_body = |pair: &ContactPair| {
            let sides = [&pair.upper, &pair.lower];
            sides
                .iter()
                .any(|side| side.body(&scene.mesh) == Some(body))
        };
        let pairs = scene.contacts.iter().enumerate();
        let pressures = pairs
            .filter(|(_, pair)| on_body(pair))
            .map(|(pair, _)| self.unseen_pressure(pair));
        BELOW * pressures.fold(0.0, f64::max)
    }

    /// Does no contact surface end while it carries pressure?
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Is a point so near to a loaded edge that its stress belongs to the edge?
    ///
    /// The edge may be that of the other body: its end presses a singularity into this one too.
    pub fn are_near(&self, at: &[f64; 3]) -> bool {
        (self.nodes.iter()).any(|(edge, reach)| distance(*edge, *at) <= *reach)
    }
}

/// Boxes about the carrier's nodes in contact, each as large as half of the faces around it, and their pressures.
struct Pressed(Vec<([f64; 3], f64, f64)>);

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

    /// The largest pressure of those that reach the box about a face, or a side of it.
    fn at(&self, mesh: &Mesh, nodes: &[u32]) -> Option<f64> {
        let (low, high) = bounds(mesh, nodes.iter().copied());
        let reaches = |(at, size, _): &&([f64; 3], f64, f64)| {
            (0..3).all(|i| at[i] + size >= low[i] && at[i] - size <= high[i])
        };
        largest(self.0.iter().filter(reaches).map(|(_, _, p)| *p))
    }
}

fn largest(values: impl Iterator<Item = f64>) -> Option<f64> {
    values.reduce(f64::max)
}

/// Diagonal of the box about a surface and its images: as large whether mirror planes are made use of or not.
fn whole_extent(scene: &Scene, surface: &Surface) -> f64 {
    let nodes = surface.faces.iter().flat_map(|face| face.nodes);
    let (mut low, mut high) = bounds(&scene.mesh, nodes);
    let size = distance(low, high);
    for axis in scene.mirrors.iter().copied().filter(|axis| *axis < 3) {
        // A surface apart from the plane is not the half of one.
        if low[axis].abs().min(high[axis].abs()) <= 1e-6 * size {
            let half = low[axis].abs().max(high[axis].abs());
            (low[axis], high[axis]) = (-half, half);
        }
    }
    distance(low, high)
}

/// Diagonal of the box about a surface.
fn extent(mesh: &Mesh, surface: &Surface) -> f64 {
    let (low, high) = bounds(mesh, surface.faces.iter().flat_map(|face| face.nodes));
    distance(low, high)
}

/// The corners of the box about some nodes.
fn bounds(mesh: &Mesh, nodes: impl Iterator<Item = u32>) -> ([f64; 3], [f64; 3]) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for node in nodes {
        for (axis, x) in mesh.points[node as usize].iter().enumerate() {
            low[axis] = low[axis].min(*x);
            high[axis] = high[axis].max(*x);
        }
    }
    (low, high)
}

/// Nodes on edges that only one face of the surface has, ascending; without mirror planes.
fn boundary_nodes(scene: &Scene, surface: &Surface) -> Vec<u32> {
    let mut uses: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for face in &surface.faces {
        for i in 0..4 {
            let (a, b) = (face.nodes[i], face.nodes[(i + 1) % 4]);
            *uses.entry((a.min(b), a.max(b))).or_default() += 1;
        }
    }
    // Where nodes hang a face ends at two smaller ones.
    for hanging in &scene.mesh.hanging {
        if let [a, b] = *hanging.corners.as_slice() {
            let m = hanging.node;
            let sides = [(a, b), (a.min(m), a.max(m)), (b.min(m), b.max(m))];
            if sides.iter().all(|side| uses.contains_key(side)) {
                sides.iter().for_each(|side| {
                    uses.remove(side);
                });
            }
        }
    }
    let once = uses.iter().filter(|(_, n)| **n == 1).map(|(edge, _)| *edge);
    let mirrors = mirror_planes(scene);
    let mirrored = |(a, b): &(u32, u32)| {
        let [a, b] = [a, b].map(|n| scene.mesh.points[*n as usize]);
        let tolerance = 1e-6 * distance(a, b);
        let on = |(axis, at): &(usize, f64)| {
            (a[*axis] - at).abs() <= tolerance && (b[*axis] - at).abs() <= tolerance
        };
        mirrors.iter().any(on)
    };
    let mut nodes: Vec<u32> = once
        .filter(|edge| !mirrored(edge))
        .flat_map(|(a, b)| [a, b])
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// Axis and place of the mirror planes, and of flat surfaces across an axis that a support holds
/// along it.
fn mirror_planes(scene: &Scene) -> Vec<(usize, f64)> {
    let axes = scene.mirrors.iter().filter(|axis| **axis < 3);
    let mut planes: Vec<(usize, f64)> = axes.map(|axis| (*axis, 0.0)).collect();
    for support in &scene.supports {
        let Some(surface) = scene.mesh.surface(&support.surface) else {
            continue;
        };
        for axis in (0..3).filter(|axis| support.components[*axis] == Some(0.0)) {
            let nodes = surface.nodes();
            let mut at = nodes.iter().map(|n| scene.mesh.points[*n as usize][axis]);
            let Some(first) = at.next() else { continue };
            // Bodies are moved into touch along directions with rounding in them.
            let size = extent(&scene.mesh, surface);
            if support.gradient[axis] == [0.0; 3] && at.all(|x| (x - first).abs() <= 1e-9 * size) {
                planes.push((axis, first));
            }
        }
    }
    planes
}
