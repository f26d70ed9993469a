//! The nodes of a split mesh: old ones, and new ones at the middles of edges, faces and elements.

use crate::model::mesh::hexahedron::{CORNERS, EDGES, FACES};
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::{Face, Mesh};
use std::collections::HashMap;

/// Old and new nodes, the new ones by the old ones that they lie between.
pub(super) struct Nodes {
    pub points: Vec<[f64; 3]>,
    edges: HashMap<[u32; 2], u32>,
    faces: HashMap<[u32; 4], u32>,
    /// Round shapes, by the edges and faces that lie on them.
    round_edges: HashMap<[u32; 2], Shape>,
    round_faces: HashMap<[u32; 4], Shape>,
}

impl Nodes {
    /// Those of `mesh`, and the round shapes of its surfaces.
    pub fn new(mesh: &Mesh) -> Self {
        let mut nodes = Self {
            points: mesh.points.clone(),
            edges: HashMap::new(),
            faces: HashMap::new(),
            round_edges: HashMap::new(),
            round_faces: HashMap::new(),
        };
        for surface in &mesh.surfaces {
            let shape = fit(mesh, surface);
            if shape.radius().is_none() {
                continue;
            }
            for face in &surface.faces {
                nodes.round_faces.entry(sorted(face.nodes)).or_insert(shape);
                for k in 0..4 {
                    let edge = sorted([face.nodes[k], face.nodes[(k + 1) % 4]]);
                    nodes.round_edges.entry(edge).or_insert(shape);
                }
            }
        }
        nodes
    }

    fn add(&mut self, point: [f64; 3]) -> u32 {
        self.points.push(point);
        (self.points.len() - 1) as u32
    }

    /// The middle of an edge, on the round surface that the edge lies on.
    fn edge(&mut self, ends: [u32; 2]) -> u32 {
        let key = sorted(ends);
        if let Some(node) = self.edges.get(&key) {
            return *node;
        }
        let middle = self.mean(&[(0.5, &key)]);
        let point = on(self.round_edges.get(&key), middle);
        let node = self.add(point);
        self.edges.insert(key, node);
        node
    }

    /// The middle of a face: between the middles of its edges, so that it follows curved ones.
    fn face(&mut self, corners: [u32; 4]) -> u32 {
        let key = sorted(corners);
        if let Some(node) = self.faces.get(&key) {
            return *node;
        }
        let edges = [0, 1, 2, 3].map(|k| self.edge([corners[k], corners[(k + 1) % 4]]));
        let middle = self.mean(&[(0.5, &edges), (-0.25, &corners)]);
        let point = on(self.round_faces.get(&key), middle);
        let node = self.add(point);
        self.faces.insert(key, node);
        node
    }

    /// The 27 nodes of a split hexahedron, by [`place`].
    pub fn lattice(&mut self, hex: &[u32; 8]) -> [u32; 27] {
        let mut lattice = [0; 27];
        for (corner, node) in CORNERS.iter().zip(hex) {
            lattice[place(*corner)] = *node;
        }
        let edges = EDGES.map(|ends| self.edge(ends.map(|c| hex[c])));
        for (ends, node) in EDGES.iter().zip(edges) {
            lattice[place(middle(ends))] = node;
        }
        let faces = FACES.map(|face| self.face(face.map(|c| hex[c])));
        for (face, node) in FACES.iter().zip(faces) {
            lattice[place(middle(face))] = node;
        }
        let centre = self.mean(&[(0.5, &faces), (-0.25, &edges), (0.125, hex)]);
        lattice[place([0.0; 3])] = self.add(centre);
        lattice
    }

    /// The four pieces of a face, each on its piece of the element.
    pub fn quarter(&self, mesh: &Mesh, face: &Face) -> Vec<Face> {
        let middle = self.faces.get(&sorted(face.nodes));
        let hex = &mesh.hexes[face.element as usize];
        let piece = |k: usize| {
            let [before, here, after] = [3, 0, 1].map(|step| face.nodes[(k + step) % 4]);
            let corner = hex.iter().position(|n| *n == here)?;
            Some(Face {
                nodes: [
                    here,
                    *self.edges.get(&sorted([here, after]))?,
                    *middle?,
                    *self.edges.get(&sorted([before, here]))?,
                ],
                element: 8 * face.element + corner as u32,
            })
        };
        (0..4).filter_map(piece).collect()
    }

    /// Sum of points, each list with its weight; Coons' blend of edges and faces.
    fn mean(&self, lists: &[(f64, &[u32])]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (weight, nodes) in lists {
            for node in *nodes {
                for (s, c) in sum.iter_mut().zip(self.points[*node as usize]) {
                    *s += weight * c;
                }
            }
        }
        sum
    }
}

/// The piece of a hexahedron at `corner`.
pub(super) fn child(lattice: &[u32; 27], corner: [f64; 3]) -> [u32; 8] {
    CORNERS.map(|other| lattice[place([0, 1, 2].map(|k| 0.5 * (corner[k] + other[k])))])
}

/// Index in the lattice of natural coordinates that are −1, 0 or 1.
fn place(at: [f64; 3]) -> usize {
    let [x, y, z] = at.map(|c| (c + 1.0) as usize);
    x + 3 * (y + 3 * z)
}

/// Mean of natural coordinates of corners.
fn middle(corners: &[usize]) -> [f64; 3] {
    let share = 1.0 / corners.len() as f64;
    [0, 1, 2].map(|k| share * corners.iter().map(|c| CORNERS[*c][k]).sum::<f64>())
}

/// The point of a round shape next to `point`; without a shape the point itself.
fn on(shape: Option<&Shape>, point: [f64; 3]) -> [f64; 3] {
    let foot = shape.and_then(|shape| shape.project(point));
    foot.map_or(point, |(foot, _)| foot)
}

fn sorted<const N: usize>(mut nodes: [u32; N]) -> [u32; N] {
    nodes.sort_unstable();
    nodes
}
