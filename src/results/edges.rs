//! Loaded edges of contact surfaces, where elastic stresses are singular.
//!
//! A contact surface that ends while it still carries pressure, such as the end of a square
//! roller, has no finite elastic stress there: a peak beside it grows with every refinement until
//! plasticity bounds it.

use std::collections::BTreeMap;

use super::State;
use super::hex::{diagonal, distance};
use super::peaks::{Peak, Place};
use crate::mesh::{Mesh, Surface};
use crate::scene::Scene;

/// Positions of the nodes on boundaries of contact surfaces that carry pressure, in the state.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LoadedEdges {
    positions: Vec<[f64; 3]>,
    /// The stress of an edge reaches so far: a fiftieth of the contact surface, some half-widths.
    reach: f64,
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
        let (mut positions, mut reach) = (Vec::new(), 0.0f64);
        for (pair, field) in state.contacts.iter().enumerate() {
            let Some(surface) = carrier(scene, pair) else {
                continue;
            };
            let boundary = boundary_nodes(scene, surface);
            reach = reach.max(REACH * extent(&scene.mesh, surface));
            for (i, node) in field.nodes.iter().enumerate() {
                if field.is_active(i) && boundary.binary_search(node).is_ok() {
                    positions.push(moved(&scene.mesh, state, *node as usize));
                }
            }
        }
        Self { positions, reach }
    }

    /// Does no contact surface end while it carries pressure?
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Does what is read at `at`, undeformed, in `element` belong to a loaded edge? So near to one is
    /// its stress, or, on a coarse mesh, the element beside it: everything else is away from edges.
    ///
    /// The edge may be that of the other body: its end presses a singularity into this one too.
    pub fn are_near(&self, mesh: &Mesh, state: &State, element: usize, at: &[f64; 3]) -> bool {
        if self.is_empty() {
            return false;
        }
        let offset = mean_displacement(mesh, state, element);
        let at = [0, 1, 2].map(|i| at[i] + offset[i]);
        let reach = self.reach.max(diagonal(&mesh.corners(element)));
        let mut edges = self.positions.iter();
        edges.any(|edge| distance(*edge, at) <= reach)
    }

    /// The same of a peak.
    pub fn touches(&self, mesh: &Mesh, state: &State, peak: &Peak) -> bool {
        if self.is_empty() {
            return false;
        }
        let element = match peak.place {
            Place::Element(element) | Place::IntegrationPoint { element, .. } => Some(element),
            Place::Node(node) => mesh.hexes.iter().position(|h| h.contains(&(node as u32))),
        };
        element.is_some_and(|element| self.are_near(mesh, state, element, &peak.at))
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

fn moved(mesh: &Mesh, state: &State, node: usize) -> [f64; 3] {
    [0, 1, 2].map(|i| mesh.points[node][i] + state.displacement[node][i])
}

fn mean_displacement(mesh: &Mesh, state: &State, element: usize) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for node in mesh.hexes[element] {
        for (s, u) in sum.iter_mut().zip(state.displacement[node as usize]) {
            *s += 0.125 * u;
        }
    }
    sum
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
            let size = first.abs();
            if support.gradient[axis] == [0.0; 3] && at.all(|x| (x - first).abs() <= 1e-9 * size) {
                planes.push((axis, first));
            }
        }
    }
    planes
}
