//! Loaded edges of contact surfaces, where elastic stresses are singular.
//!
//! A contact surface that ends while it still carries pressure, such as the end of a square
//! roller, has no finite elastic stress there: a peak beside it grows with every refinement until
//! plasticity bounds it.

use std::collections::BTreeMap;

use super::State;
use super::hex::distance;
use crate::mesh::{Mesh, Surface};
use crate::scene::Scene;

/// The loaded edges of a state.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadedEdges {
    /// Nodes on boundaries of contact surfaces that are in contact, and how far the stress of the edge
    /// reaches: a fiftieth of the contact surface, some half-widths, and no less than the face there is long.
    nodes: Vec<([f64; 3], f64)>,
}

/// Of the size of a contact surface.
const REACH: f64 = 0.02;

/// The surface whose nodes carry the pressure of a pair; `None` where the mesh has none.
pub fn carrier(scene: &Scene, pair: usize) -> Option<&Surface> {
    let [carrier, _] = scene.contacts.get(pair)?.carrier_first();
    carrier.surface(&scene.mesh)
}

impl LoadedEdges {
    /// Finds the loaded edges of every contact pair; edges on mirror planes, and on flat ends that
    /// are held as by a mirror, are none.
    pub fn find(scene: &Scene, state: &State) -> Self {
        let mut edges = Self::default();
        for (pair, field) in state.contacts.iter().enumerate() {
            let Some(surface) = carrier(scene, pair) else {
                continue;
            };
            let active: Vec<u32> = (field.nodes.iter().enumerate())
                .filter(|(i, _)| field.is_active(*i))
                .map(|(_, node)| *node)
                .collect();
            if active.is_empty() {
                continue;
            }
            edges.add(scene, surface, |side| {
                side.iter().any(|n| active.binary_search(n).is_ok())
            });
            // Where the other surface ends, the carrier may go on.
            let [_, other] = scene.contacts[pair].carrier_first();
            if let Some(other) = other.surface(&scene.mesh) {
                let pressed = Pressed::new(scene, surface, &active);
                edges.add(scene, other, |side| {
                    pressed.reaches(&side.map(|n| scene.mesh.points[n as usize]))
                });
            }
        }
        edges
    }

    /// Adds the sides of faces on the boundary of a surface that are under pressure.
    fn add(&mut self, scene: &Scene, surface: &Surface, loaded: impl Fn(&[u32; 2]) -> bool) {
        let mesh = &scene.mesh;
        let boundary = boundary_nodes(scene, surface);
        let on_boundary = |node: &u32| boundary.binary_search(node).is_ok();
        for face in &surface.faces {
            for k in 0..4 {
                let side = [face.nodes[k], face.nodes[(k + 1) % 4]];
                if !side.iter().all(on_boundary) || !loaded(&side) {
                    continue;
                }
                let corners = face.corners(mesh);
                let reach = distance(corners[0], corners[2]).max(REACH * extent(mesh, surface));
                self.nodes
                    .extend(side.map(|n| (mesh.points[n as usize], reach)));
            }
        }
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

/// Boxes about the carrier's nodes in contact, each as large as half of the faces around it.
struct Pressed(Vec<([f64; 3], f64)>);

impl Pressed {
    fn new(scene: &Scene, surface: &Surface, active: &[u32]) -> Self {
        let mut sizes: BTreeMap<u32, f64> = BTreeMap::new();
        for face in &surface.faces {
            let corners = face.corners(&scene.mesh);
            let size = 0.5 * distance(corners[0], corners[2]);
            for node in face
                .nodes
                .iter()
                .filter(|n| active.binary_search(n).is_ok())
            {
                let known = sizes.entry(*node).or_default();
                *known = known.max(size);
            }
        }
        let boxes = sizes
            .into_iter()
            .map(|(n, size)| (scene.mesh.points[n as usize], size));
        Self(boxes.collect())
    }

    /// Does one of them reach the side of a face between these ends?
    fn reaches(&self, ends: &[[f64; 3]; 2]) -> bool {
        self.0.iter().any(|(at, size)| {
            (0..3).all(|i| {
                let [low, high] = [ends[0][i].min(ends[1][i]), ends[0][i].max(ends[1][i])];
                at[i] + size >= low && at[i] - size <= high
            })
        })
    }
}

/// Diagonal of the box about a surface.
fn extent(mesh: &Mesh, surface: &Surface) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for node in surface.faces.iter().flat_map(|face| face.nodes) {
        for (axis, x) in mesh.points[node as usize].iter().enumerate() {
            low[axis] = low[axis].min(*x);
            high[axis] = high[axis].max(*x);
        }
    }
    distance(low, high)
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
