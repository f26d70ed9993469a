//! The nodes of a split mesh: old ones, and new ones at the middles of edges, faces and elements.

use crate::ground::geometry::{Vec3, add};
use crate::model::mesh::hexahedron::{CORNERS, EDGES, FACES};
use crate::model::mesh::shape::{Shape, fit};
use crate::model::mesh::split::smooth::bulges;
use crate::model::mesh::surface::sorted;
use crate::model::mesh::{Hanging, Mesh};
use std::collections::{HashMap, HashSet};

/// Along which of its own directions, from corner 0 to corners 1, 3 and 4, an element is split.
pub type Directions = [bool; 3];

/// Old and new nodes, the new ones by the old ones that they lie between.
pub(super) struct Nodes {
    pub points: Vec<[f64; 3]>,
    edges: HashMap<[u32; 2], u32>,
    faces: HashMap<[u32; 4], u32>,
    /// Round shapes, by the edges and faces that lie on them.
    round_edges: HashMap<[u32; 2], Shape>,
    round_faces: HashMap<[u32; 4], Shape>,
    /// From the middles of edges on other smooth surfaces to those of the arcs over them.
    bulges: HashMap<[u32; 2], Vec3>,
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
            bulges: HashMap::new(),
        };
        let mut flat = HashSet::new();
        for surface in &mesh.surfaces {
            let shape = fit(mesh, surface);
            if let Shape::Plane { .. } = shape {
                flat.extend(surface.faces.iter().map(|face| sorted(face.nodes)));
            }
            if shape.radius().is_none() {
                continue;
            }
            for face in &surface.faces {
                nodes.round_faces.entry(sorted(face.nodes)).or_insert(shape);
                for k in 0..4 {
                    nodes.round_edges.entry(face.edge(k)).or_insert(shape);
                }
            }
        }
        nodes.bulges = bulges(mesh, &flat);
        nodes
    }

    /// The same of a mesh with hanging nodes, whose elements are split along the directions of `marks`. What no longer hangs
    /// comes to lie on the round surface that it is of.
    pub fn with_hanging(mesh: &Mesh, marks: &[Directions]) -> Self {
        let mut nodes = Self::new(mesh);
        let mut keys: HashSet<&[u32]> = HashSet::new();
        let mut held = Vec::new();
        for (hex, mark) in mesh.hexes.iter().zip(marks) {
            nodes.flatten(hex, *mark);
            held.extend(whole(hex, *mark));
        }
        keys.extend(held.iter().map(Vec::as_slice));
        let released = |h: &&Hanging| !keys.contains(h.corners.as_slice());
        let released: HashSet<u32> = (mesh.hanging.iter().filter(released))
            .map(|h| h.node)
            .collect();
        for surface in mesh.surfaces.iter().filter(|_| !released.is_empty()) {
            let shape = fit(mesh, surface);
            let own = surface.nodes().into_iter().filter(|n| released.contains(n));
            for node in own.filter(|_| shape.radius().is_some()) {
                let at = nodes.points[node as usize];
                nodes.points[node as usize] = on(Some(&shape), at);
            }
        }
        for hanging in &mesh.hanging {
            match *hanging.corners.as_slice() {
                [a, b] => nodes.edges.insert([a, b], hanging.node),
                [a, b, c, d] => nodes.faces.insert([a, b, c, d], hanging.node),
                _ => None,
            };
        }
        nodes
    }

    /// Edges and faces of an element that stay whole stay straight, though they lie on a round surface.
    fn flatten(&mut self, hex: &[u32; 8], mark: Directions) {
        for key in whole(hex, mark) {
            match *key.as_slice() {
                [a, b] => {
                    self.bulges.remove(&[a, b]);
                    self.round_edges.remove(&[a, b])
                }
                [a, b, c, d] => self.round_faces.remove(&[a, b, c, d]),
                _ => None,
            };
        }
    }

    /// Nodes on the edges and faces of an element that has no node there itself, each with the corners around it.
    pub fn hanging(&self, hex: &[u32; 8]) -> Vec<(u32, Vec<u32>)> {
        let edges = EDGES.map(|ends| sorted(ends.map(|c| hex[c])));
        let faces = FACES.map(|face| sorted(face.map(|c| hex[c])));
        let of_edges = edges
            .iter()
            .filter_map(|key| Some((*self.edges.get(key)?, key.to_vec())));
        let of_faces = faces
            .iter()
            .filter_map(|key| Some((*self.faces.get(key)?, key.to_vec())));
        of_edges.chain(of_faces).collect()
    }

    fn add(&mut self, point: [f64; 3]) -> u32 {
        self.points.push(point);
        (self.points.len() - 1) as u32
    }

    /// The middle of an edge, on the round or smooth surface that the edge lies on.
    fn edge(&mut self, ends: [u32; 2]) -> u32 {
        let key = sorted(ends);
        if let Some(node) = self.edges.get(&key) {
            return *node;
        }
        let middle = self.mean(&[(0.5, &key)]);
        let point = match (self.round_edges.get(&key), self.bulges.get(&key)) {
            (None, Some(bulge)) => add(middle, *bulge),
            (shape, _) => on(shape, middle),
        };
        let node = self.add(point);
        self.edges.insert(key, node);
        node
    }

    /// The middle of a face: between the middles of its edges, so that it follows curved ones. It is that of the edges, too,
    /// that a split along one direction leaves across the face on the other side of it.
    fn face(&mut self, corners: [u32; 4]) -> u32 {
        let key = sorted(corners);
        if let Some(node) = self.faces.get(&key) {
            return *node;
        }
        let edges = [0, 1, 2, 3].map(|k| self.edge([corners[k], corners[(k + 1) % 4]]));
        let across = [0, 1].map(|k| sorted([edges[k], edges[k + 2]]));
        let there = across.iter().find_map(|key| self.edges.get(key).copied());
        let node = there.unwrap_or_else(|| {
            let middle = self.mean(&[(0.5, &edges), (-0.25, &corners)]);
            self.add(on(self.round_faces.get(&key), middle))
        });
        self.edges.extend(across.map(|key| (key, node)));
        self.faces.insert(key, node);
        node
    }

    /// The 27 nodes of a split hexahedron, by [`place`].
    pub fn lattice(&mut self, hex: &[u32; 8]) -> [u32; 27] {
        let mut lattice = corners_only(hex);
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

    /// Those of the 27 nodes of [`lattice`](Self::lattice) that an element split along some directions has.
    pub fn part(&mut self, hex: &[u32; 8], mark: Directions) -> [u32; 27] {
        if mark == [true; 3] {
            return self.lattice(hex);
        }
        let mut lattice = corners_only(hex);
        for ends in EDGES.iter().filter(|ends| cuts(*ends, mark) == 1) {
            lattice[place(middle(ends))] = self.edge(ends.map(|c| hex[c]));
        }
        for face in FACES.iter().filter(|face| cuts(*face, mark) == 2) {
            lattice[place(middle(face))] = self.face(face.map(|c| hex[c]));
        }
        lattice
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

/// A lattice with the nodes of the element itself.
fn corners_only(hex: &[u32; 8]) -> [u32; 27] {
    let mut lattice = [0; 27];
    for (corner, node) in CORNERS.iter().zip(hex) {
        lattice[place(*corner)] = *node;
    }
    lattice
}

/// The piece at `corner` of a hexahedron that is split along some directions.
pub(super) fn child(lattice: &[u32; 27], corner: [f64; 3], mark: Directions) -> [u32; 8] {
    let half = |k: usize, other: &[f64; 3]| match mark[k] {
        true => 0.5 * (corner[k] + other[k]),
        false => other[k],
    };
    CORNERS.map(|other| lattice[place([0, 1, 2].map(|k| half(k, &other)))])
}

/// Along how many directions an edge or a face is split with its element.
fn cuts(corners: &[usize], mark: Directions) -> usize {
    let varies = |k: &usize| {
        corners
            .iter()
            .any(|c| CORNERS[*c][*k] != CORNERS[corners[0]][*k])
    };
    (0..3).filter(|k| mark[*k]).filter(varies).count()
}

/// Edges and faces of an element that stay whole, by their nodes, ascending.
fn whole(hex: &[u32; 8], mark: Directions) -> impl Iterator<Item = Vec<u32>> {
    let edges = EDGES.into_iter().filter(move |ends| cuts(ends, mark) == 0);
    let faces = FACES.into_iter().filter(move |face| cuts(face, mark) == 0);
    let edges = edges.map(|ends| sorted(ends.map(|c| hex[c])).to_vec());
    edges.chain(faces.map(|face| sorted(face.map(|c| hex[c])).to_vec()))
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
