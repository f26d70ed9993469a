//! Structured meshes of mapped boxes.

use miette::Diagnostic;
use thiserror::Error;

use super::hexahedron::{Orientation, orientation};
use super::surface::faces_of;
use super::{Body, Face, Mesh, Surface};

/// Names of the six faces of a block, in the order of
/// [`FACES`](crate::model::mesh::surface::FACES).
const FACE_NAMES: [&str; 6] = ["z_min", "z_max", "y_min", "x_max", "y_max", "x_min"];

/// What is wrong with a structured mesh.
#[derive(Debug, Error, Diagnostic, PartialEq)]
pub enum BlockError {
    /// Coordinates do not ascend.
    #[error("block `{block}`: the {axis} coordinates are not two or more ascending numbers")]
    #[diagnostic(
        code(brinell::mesh::block_coordinates),
        help("give each axis finite coordinates in strictly ascending order")
    )]
    Coordinates {
        /// Name of the block.
        block: String,
        /// The axis: x, y or z.
        axis: char,
    },
    /// There are too many nodes or elements.
    #[error("block `{block}`: {count} nodes or elements are too many")]
    #[diagnostic(code(brinell::mesh::block_size), help("use fewer coordinates"))]
    TooLarge {
        /// Name of the block.
        block: String,
        /// How many.
        count: usize,
    },
    /// The map spoils an element.
    #[error("block `{block}`: the map turns element {element} inside out or flattens it")]
    #[diagnostic(
        code(brinell::mesh::block_map),
        help("the map must keep the handedness of (x, y, z): exchange two axes or turn one round")
    )]
    Map {
        /// Name of the block.
        block: String,
        /// Index of the element.
        element: usize,
    },
    /// A face does not exist.
    #[error("block `{block}` has no face `{face}`")]
    #[diagnostic(
        code(brinell::mesh::block_face),
        help("the faces are x_min, x_max, y_min, y_max, z_min and z_max")
    )]
    Face {
        /// Name of the block.
        block: String,
        /// Name of the face.
        face: String,
    },
}

type Map<'a> = Box<dyn Fn([f64; 3]) -> [f64; 3] + 'a>;

/// A box of hexahedra between coordinate planes, mapped to any shape.
///
/// ```
/// use brinell::model::mesh::block::{Block, cylindrical, uniform};
/// // A quarter of a tube: radius, angle, height.
/// let tube = Block::new("tube", uniform(1.0, 2.0, 4), uniform(0.0, 1.5707963, 8), uniform(0.0, 1.0, 2))
///     .mapped(cylindrical)
///     .face("x_min", "bore")
///     .build()?;
/// assert_eq!(tube.hexes.len(), 64);
/// assert!(tube.surface("bore").is_some());
/// # Ok::<(), brinell::model::mesh::block::BlockError>(())
/// ```
pub struct Block<'a> {
    name: String,
    coordinates: [Vec<f64>; 3],
    face_names: [String; 6],
    unknown_face: Option<String>,
    map: Option<Map<'a>>,
}

impl<'a> Block<'a> {
    /// A block whose body is called `name`, with nodes at the crossings of ascending coordinates.
    /// Its surfaces are called `x_min`, `x_max`, `y_min`, `y_max`, `z_min` and `z_max`.
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>, z: Vec<f64>) -> Self {
        let face_names = FACE_NAMES.map(String::from);
        Self {
            name: name.into(),
            coordinates: [x, y, z],
            face_names,
            unknown_face: None,
            map: None,
        }
    }

    /// Moves every node by `map`, which must keep the handedness.
    pub fn mapped(mut self, map: impl Fn([f64; 3]) -> [f64; 3] + 'a) -> Self {
        self.map = Some(Box::new(map));
        self
    }

    /// Calls the surface of face `face` (`x_min`, ...) `name`. [`build`](Self::build) reports a
    /// face that does not exist.
    pub fn face(mut self, face: &str, name: impl Into<String>) -> Self {
        match FACE_NAMES.iter().position(|f| *f == face) {
            Some(k) => self.face_names[k] = name.into(),
            None => self.unknown_face = Some(face.into()),
        }
        self
    }

    /// The mesh: nodes and elements with x running fastest, then y, then z.
    pub fn build(self) -> Result<Mesh, BlockError> {
        if let Some(face) = self.unknown_face {
            return Err(BlockError::Face {
                block: self.name,
                face,
            });
        }
        for (axis, list) in ['x', 'y', 'z'].into_iter().zip(&self.coordinates) {
            let ascending = list.windows(2).all(|w| w[0] < w[1]);
            if list.len() < 2 || !ascending || !list.iter().all(|c| c.is_finite()) {
                return Err(BlockError::Coordinates {
                    block: self.name,
                    axis,
                });
            }
        }
        let [xs, ys, zs] = &self.coordinates;
        let counts = [xs.len(), ys.len(), zs.len()];
        let count = counts.iter().fold(1usize, |a, &b| a.saturating_mul(b));
        if count > u32::MAX as usize {
            return Err(BlockError::TooLarge {
                block: self.name,
                count,
            });
        }
        let mut points = Vec::with_capacity(count);
        for &z in zs {
            for &y in ys {
                for &x in xs {
                    let p = [x, y, z];
                    points.push(self.map.as_ref().map_or(p, |map| map(p)));
                }
            }
        }
        let cells = counts.map(|n| n - 1);
        let node = |i: usize, j: usize, k: usize| (i + counts[0] * (j + counts[1] * k)) as u32;
        let mut hexes = Vec::with_capacity(cells.iter().product());
        let mut surfaces = self.face_names.map(|name| Surface {
            name,
            faces: Vec::new(),
        });
        for k in 0..cells[2] {
            for j in 0..cells[1] {
                for i in 0..cells[0] {
                    let ring = |k| {
                        [
                            node(i, j, k),
                            node(i + 1, j, k),
                            node(i + 1, j + 1, k),
                            node(i, j + 1, k),
                        ]
                    };
                    let ([a, b, c, d], [e, f, g, h]) = (ring(k), ring(k + 1));
                    let hex = [a, b, c, d, e, f, g, h];
                    let element = hexes.len() as u32;
                    let outer = [
                        k == 0,
                        k + 1 == cells[2],
                        j == 0,
                        i + 1 == cells[0],
                        j + 1 == cells[1],
                        i == 0,
                    ];
                    for ((nodes, outer), surface) in
                        faces_of(&hex).into_iter().zip(outer).zip(&mut surfaces)
                    {
                        if outer {
                            surface.faces.push(Face { nodes, element });
                        }
                    }
                    hexes.push(hex);
                }
            }
        }
        let bodies = vec![Body {
            name: self.name.clone(),
            elements: 0..hexes.len(),
        }];
        let mesh = Mesh {
            source: format!("block `{}`", self.name),
            points,
            hexes,
            bodies,
            surfaces: surfaces.into(),
            hanging: Vec::new(),
            fingerprint: None,
        };
        let wrong = |e: &usize| orientation(&mesh.corners(*e)) != Orientation::Sound;
        if let Some(element) = (0..mesh.hexes.len()).find(wrong) {
            return Err(BlockError::Map {
                block: self.name,
                element,
            });
        }
        Ok(mesh)
    }
}

/// `cells + 1` equally spaced coordinates from `from` to `to`.
pub fn uniform(from: f64, to: f64, cells: usize) -> Vec<f64> {
    graded(from, to, cells, 1.0)
}

/// `cells + 1` coordinates from `from` to `to`, each cell `ratio` times as long as the one before.
pub fn graded(from: f64, to: f64, cells: usize, ratio: f64) -> Vec<f64> {
    let total: f64 = (0..cells).map(|k| ratio.powi(k as i32)).sum();
    let mut list = Vec::with_capacity(cells + 1);
    let (mut sum, mut length) = (0.0, 1.0);
    for _ in 0..cells {
        list.push(from + (to - from) * sum / total);
        sum += length;
        length *= ratio;
    }
    list.push(to);
    list
}

/// Cylindrical to Cartesian coordinates: (radius, angle in radians from x towards y, z).
pub fn cylindrical([radius, angle, z]: [f64; 3]) -> [f64; 3] {
    [radius * angle.cos(), radius * angle.sin(), z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::hexahedron::volume;

    fn cube(name: &str) -> Mesh {
        let list = || uniform(0.0, 1.0, 2);
        Block::new(name, list(), list(), list()).build().unwrap()
    }

    #[test]
    fn the_faces_carry_their_outward_normals() {
        let mesh = cube("cube");
        assert_eq!((mesh.points.len(), mesh.hexes.len()), (27, 8));
        let normals = [("x_min", 0, -1.0), ("x_max", 0, 1.0), ("y_min", 1, -1.0)];
        let more = [("y_max", 1, 1.0), ("z_min", 2, -1.0), ("z_max", 2, 1.0)];
        for (name, axis, sign) in normals.into_iter().chain(more) {
            let surface = mesh.surface(name).unwrap();
            assert_eq!(surface.faces.len(), 4, "{name}");
            let sum: f64 = surface
                .faces
                .iter()
                .map(|f| f.area_vector(&mesh)[axis])
                .sum();
            assert!((sum - sign).abs() < 1e-15, "{name}");
            for node in surface.nodes() {
                assert_eq!(
                    mesh.points[node as usize][axis],
                    f64::max(sign, 0.0),
                    "{name}"
                );
            }
        }
        assert_eq!(mesh.outer_faces(0).len(), 24);
    }

    #[test]
    fn a_half_annulus_has_the_volume_of_its_polygon() {
        let angles = uniform(0.0, std::f64::consts::PI, 12);
        let tube = Block::new(
            "tube",
            graded(1.0, 2.0, 4, 1.3),
            angles,
            uniform(0.0, 3.0, 2),
        )
        .mapped(cylindrical)
        .build()
        .unwrap();
        let total: f64 = (0..tube.hexes.len())
            .map(|e| volume(&tube.corners(e)))
            .sum();
        let exact = 3.0 * 12.0 * 0.5 * (4.0 - 1.0) * (std::f64::consts::PI / 12.0).sin();
        assert!((total / exact - 1.0).abs() < 1e-13);
    }

    #[test]
    fn wrong_blocks_are_refused() {
        let list = || uniform(0.0, 1.0, 2);
        let backward = Block::new("b", vec![1.0, 0.0], list(), list()).build();
        assert_eq!(
            backward,
            Err(BlockError::Coordinates {
                block: "b".into(),
                axis: 'x'
            })
        );
        let face = Block::new("b", list(), list(), list())
            .face("top", "roof")
            .build();
        assert_eq!(
            face,
            Err(BlockError::Face {
                block: "b".into(),
                face: "top".into()
            })
        );
        let mirror = Block::new("b", list(), list(), list())
            .mapped(|[x, y, z]| [-x, y, z])
            .build();
        assert_eq!(
            mirror,
            Err(BlockError::Map {
                block: "b".into(),
                element: 0
            })
        );
    }
}
