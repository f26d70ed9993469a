//! Loaded edges of contact surfaces, where elastic stresses are singular.
//!
//! A contact surface that ends while it still carries pressure, such as the end of a square
//! roller, has no finite elastic stress there: a peak beside it grows with every refinement until
//! plasticity bounds it.

use std::collections::BTreeMap;

use super::fillet;
use super::hex::distance;
use crate::ground::geometry::{dot, sub, unit};
use crate::model::mesh::{Mesh, Surface};
use crate::model::scene::{ContactPair, EDGE_REACH, Scene};
use crate::model::state::State;

/// The loaded edges of a state. A fillet that the mesh does not resolve is one, too.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadedEdges {
    nodes: Vec<EdgeNode>,
    /// Of each contact pair the largest pressure that may be at a fillet and that the mesh does not show;
    /// zero where there is none.
    unseen: Vec<f64>,
}

/// A node on the boundary of a contact surface that is in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
struct EdgeNode {
    at: [f64; 3],
    /// Of the surface there; unit length.
    normal: [f64; 3],
    /// How far the stress of the edge reaches along the surface, and as far below it: a fiftieth of the shorter of both
    /// contact surfaces, and no less than the face there is long.
    reach: f64,
}

/// Nodes that a mesh puts where an edge ceases to reach are no longer near it, by rounding or a roller a little askew.
const SLACK: f64 = 0.01;

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
            let extents = extents.map(|surface| longest_side(scene, surface));
            let whole = EDGE_REACH * extents.fold(f64::INFINITY, f64::min);
            edges.add(scene, (pair, surface), whole, |nodes| {
                largest(nodes.iter().filter_map(of))
            });
            // Where the other surface ends or begins to curve, the carrier may go on.
            if let Some(other) = other {
                let pressed = Pressed::new(scene, surface, of);
                edges.add(scene, (pair, other), whole, |nodes| {
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
        whole: f64,
        pressure: impl Fn(&[u32]) -> Option<f64>,
    ) {
        let mesh = &scene.mesh;
        let compliance = scene.compliance(&scene.contacts[pair]).unwrap_or(0.0);
        let boundary = boundary_nodes(scene, surface);
        let on_boundary = |node: &u32| boundary.binary_search(node).is_ok();
        let fillets = fillet::beginnings(mesh, surface);
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
                let Some(normal) = unit(face.area_vector(mesh)) else {
                    continue;
                };
                let mut corners = face.corners(mesh);
                corners.rotate_left(k);
                let [a, b, c, d] = corners;
                // A face that is longer belongs to its edge as a whole.
                let is_longer = distance(a, d).max(distance(b, c)) > (1.0 + SLACK) * whole;
                let reach = if is_longer { distance(a, c) } else { whole };
                self.nodes.extend(side.map(|n| EdgeNode {
                    at: mesh.points[n as usize],
                    normal,
                    reach,
                }));
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
        self.nodes.iter().any(|edge| edge.reaches(at))
    }

    /// Does a loaded edge cease to reach just there? Meshes of the templates have nodes at such places.
    pub fn end_at(&self, at: &[f64; 3]) -> bool {
        self.nodes.iter().any(|edge| edge.ends_at(at))
    }
}

impl EdgeNode {
    fn reaches(&self, at: &[f64; 3]) -> bool {
        let [depth, along] = self.apart(at);
        depth <= 1.0 && along <= 1.0 - SLACK
    }

    fn ends_at(&self, at: &[f64; 3]) -> bool {
        let [depth, along] = self.apart(at);
        depth <= 1.0 && (along - 1.0).abs() <= SLACK
    }

    /// How far that is below or above the surface, and how far along it, in reaches.
    fn apart(&self, at: &[f64; 3]) -> [f64; 2] {
        let from = sub(*at, self.at);
        let depth = dot(from, self.normal);
        let along = (dot(from, from) - depth * depth).max(0.0).sqrt();
        [depth.abs(), along].map(|distance| distance / self.reach)
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

/// The longest side of the box about a surface and its images: as long whether mirror planes are made use of or not.
fn longest_side(scene: &Scene, surface: &Surface) -> f64 {
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
    (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max)
}

/// Diagonal of the box about a surface.
fn extent(mesh: &Mesh, surface: &Surface) -> f64 {
    let (low, high) = bounds(mesh, surface.faces.iter().flat_map(|face| face.nodes));
    distance(low, high)
}

/// The corners of the box about some nodes.
pub(super) fn bounds(mesh: &Mesh, nodes: impl Iterator<Item = u32>) -> ([f64; 3], [f64; 3]) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_reaches_as_far_along_the_surface_as_below_it() {
        let edge = EdgeNode {
            at: [1.0, 2.0, 3.0],
            normal: [0.0, 0.0, 1.0],
            reach: 0.5,
        };
        let beside = |x: f64, z: f64| edge.reaches(&[1.0 + x, 2.0, 3.0 + z]);
        assert!(beside(0.49, 0.0) && beside(-0.49, -0.49) && beside(0.0, -0.5));
        // The plane of nodes where it ends, moved by rounding, and what lies deeper.
        let ends = |x: f64, z: f64| edge.ends_at(&[1.0 + x, 2.0, 3.0 + z]);
        assert!(ends(0.5, -0.1) && ends(-0.499, 0.0) && !ends(0.48, 0.0) && !ends(0.52, 0.0));
        assert!(!beside(0.5, 0.0) && !beside(0.499, -0.2) && !beside(0.0, -0.51));
    }
}
