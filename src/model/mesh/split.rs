//! Uniform refinement: every hexahedron into eight.

use super::hexahedron::{CORNERS, EDGES, Orientation, orientation};
use super::shape::{Shape, fit};
use super::surface::FACES;
use super::{Body, Face, Mesh, Surface};
use miette::Diagnostic;
use std::collections::HashMap;
use thiserror::Error;

/// Why a mesh cannot be split.
#[derive(Debug, Error, Diagnostic, PartialEq, Eq)]
pub enum SplitError {
    #[error("the mesh {mesh} is too large to be split: {elements} hexahedra would become {result}")]
    #[diagnostic(code(brinell::mesh::split_size), help("ask for fewer levels"))]
    TooLarge {
        mesh: String,
        elements: usize,
        result: usize,
    },
    #[error(
        "splitting the mesh {mesh} turns an element of body `{body}` inside out: the surface \
         bends more within an element than the element is thick"
    )]
    #[diagnostic(
        code(brinell::mesh::split_inverted),
        help("give finer meshes by --mesh instead of having this one split")
    )]
    Inverted { mesh: String, body: String },
}

/// More hexahedra than this are no mesh that Brinell solves.
const MOST: usize = 100_000_000;

impl Mesh {
    /// Every hexahedron split into eight at the middles of its edges, faces and volume; names
    /// stay. On surfaces that fit a cylinder or sphere ([`fit`]) the new nodes are put on it,
    /// and the nodes inside follow, so that the pieces stay well shaped.
    ///
    /// # Errors
    /// [`SplitError`] for a mesh that becomes too large or folded.
    pub fn split(&self) -> Result<Mesh, SplitError> {
        let result = 8 * self.hexes.len();
        if result > MOST {
            return Err(SplitError::TooLarge {
                mesh: self.source.clone(),
                elements: self.hexes.len(),
                result,
            });
        }
        let mut nodes = Nodes::new(self);
        let lattices: Vec<[u32; 27]> = self.hexes.iter().map(|hex| nodes.lattice(hex)).collect();
        let children = lattices
            .iter()
            .flat_map(|lattice| CORNERS.map(|corner| child(lattice, corner)));
        let surfaces = self.surfaces.iter().map(|surface| Surface {
            name: surface.name.clone(),
            faces: surface
                .faces
                .iter()
                .flat_map(|face| nodes.quarter(self, face))
                .collect(),
        });
        let mesh = Mesh {
            source: format!("{}, split", self.source),
            hexes: children.collect(),
            bodies: self
                .bodies
                .iter()
                .map(|body| Body {
                    name: body.name.clone(),
                    elements: 8 * body.elements.start..8 * body.elements.end,
                })
                .collect(),
            surfaces: surfaces.collect(),
            points: nodes.points,
            fingerprint: None,
        };
        let folded = |e: &usize| orientation(&mesh.corners(*e)) != Orientation::Sound;
        match (0..mesh.hexes.len()).find(folded) {
            None => Ok(mesh),
            Some(element) => Err(SplitError::Inverted {
                body: mesh
                    .bodies
                    .get(mesh.body_of(element))
                    .map_or_else(String::new, |b| b.name.clone()),
                mesh: self.source.clone(),
            }),
        }
    }
}

/// Old and new nodes, the new ones by the old ones that they lie between.
struct Nodes {
    points: Vec<[f64; 3]>,
    edges: HashMap<[u32; 2], u32>,
    faces: HashMap<[u32; 4], u32>,
    /// Round shapes, by the edges and faces that lie on them.
    round_edges: HashMap<[u32; 2], Shape>,
    round_faces: HashMap<[u32; 4], Shape>,
}

impl Nodes {
    fn new(mesh: &Mesh) -> Self {
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
    fn lattice(&mut self, hex: &[u32; 8]) -> [u32; 27] {
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
    fn quarter(&self, mesh: &Mesh, face: &Face) -> Vec<Face> {
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
fn child(lattice: &[u32; 27], corner: [f64; 3]) -> [u32; 8] {
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

fn on(shape: Option<&Shape>, point: [f64; 3]) -> [f64; 3] {
    let foot = shape.and_then(|shape| shape.project(point));
    foot.map_or(point, |(foot, _)| foot)
}

fn sorted<const N: usize>(mut nodes: [u32; N]) -> [u32; N] {
    nodes.sort_unstable();
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::block::{Block, cylindrical, uniform};
    use crate::model::mesh::hexahedron::volume;
    use std::f64::consts::FRAC_PI_2;

    fn tube(around: usize) -> Mesh {
        Block::new(
            "tube",
            uniform(1.0, 2.0, 2),
            uniform(0.0, FRAC_PI_2, around),
            uniform(0.0, 1.0, 1),
        )
        .mapped(cylindrical)
        .build()
        .unwrap()
    }

    fn total(mesh: &Mesh) -> f64 {
        (0..mesh.hexes.len())
            .map(|e| volume(&mesh.corners(e)))
            .sum()
    }

    #[test]
    fn a_split_tube_keeps_its_surfaces_and_nears_its_true_shape() {
        let coarse = tube(6);
        let fine = coarse.split().unwrap();
        assert_eq!(fine.hexes.len(), 8 * coarse.hexes.len());
        assert_eq!(fine.points.len(), 5 * 13 * 3);
        for surface in &coarse.surfaces {
            let split = fine.surface(&surface.name).unwrap();
            assert_eq!(
                split.faces.len(),
                4 * surface.faces.len(),
                "{}",
                surface.name
            );
            for face in &split.faces {
                let hex = &fine.hexes[face.element as usize];
                assert!(face.nodes.iter().all(|n| hex.contains(n)));
            }
        }
        for (name, radius) in [("x_min", 1.0), ("x_max", 2.0)] {
            for node in fine.surface(name).unwrap().nodes() {
                let [x, y, _] = fine.points[node as usize];
                assert!((x.hypot(y) - radius).abs() < 1e-9, "{name} {x} {y}");
            }
        }
        let exact = 3.0 * FRAC_PI_2 / 2.0;
        let (before, after) = (exact - total(&coarse), exact - total(&fine));
        assert!(after > 0.0 && after < 0.3 * before, "{before} {after}");
        let outer = fine.outer_faces(0).len();
        let named: usize = fine.surfaces.iter().map(|s| s.faces.len()).sum();
        assert_eq!(outer, named);
    }

    #[test]
    fn a_split_box_is_the_box_with_halved_cells() {
        let list = |n| uniform(0.0, 1.0, n);
        let box_of = |n| {
            Block::new("box", list(n), list(n), list(n))
                .build()
                .unwrap()
        };
        let (split, direct) = (box_of(2).split().unwrap(), box_of(4));
        assert_eq!(split.points.len(), direct.points.len());
        assert_eq!(split.bodies, direct.bodies);
        for p in &direct.points {
            let near = |q: &&[f64; 3]| (0..3).all(|i| (p[i] - q[i]).abs() < 1e-15);
            assert!(split.points.iter().any(|q| near(&q)));
        }
        assert!((total(&split) - 1.0).abs() < 1e-14);
    }
}
