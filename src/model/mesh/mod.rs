//! Hexahedral meshes: bodies made of hexahedra, named surfaces made of their outer faces.

pub mod block;
pub mod family;
#[doc(hidden)]
pub mod gmsh;
#[doc(hidden)]
pub mod hexahedron;
pub mod join;
pub mod merge;
mod middle;
pub mod msh;
#[doc(hidden)]
pub mod pieces;
pub mod quadrilateral;
pub mod quality;
#[doc(hidden)]
pub mod shape;
#[doc(hidden)]
pub mod split;
pub mod surface;
#[doc(hidden)]
pub mod unfold;
mod whole;

use self::hexahedron::FACES;
use crate::ground::geometry::{Vec3, add, range};
use crate::ground::order::ascending;
use serde::Serialize;

/// An eight-node hexahedral mesh with named bodies and named surfaces.
///
/// Nodes of a hexahedron are in the order of gmsh, VTK, Abaqus and CalculiX:
///
/// ```text
///         7--------6
///        /|       /|        w
///       4--------5 |        |  v
///       | |      | |        | /
///       | 3------|-2        |/
///       |/       |/         +---- u
///       0--------1
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Mesh {
    /// Where the mesh came from, for messages: a file name or a description.
    pub source: String,
    /// Node coordinates, in the length unit of the scene.
    pub points: Vec<[f64; 3]>,
    /// Node indices of each hexahedron; the elements of a body stand together.
    pub hexes: Vec<[u32; 8]>,
    /// The bodies, in the order of their elements. They cover all of `hexes`.
    pub bodies: Vec<Body>,
    /// Named surfaces.
    pub surfaces: Vec<Surface>,
    /// Nodes that hang on elements without a node there, ascending. What a node hangs on has lower numbers than itself.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hanging: Vec<Hanging>,
    /// The fingerprint of the template parameters that made the mesh, where the file carries one.
    pub fingerprint: Option<String>,
}

/// A node on an edge or face of an element that has no node there: it moves as the mean of the corners.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Hanging {
    /// The node, in the middle,
    pub node: u32,
    /// and the two ends of the edge, or the four corners of the face.
    pub corners: Vec<u32>,
}

/// A physical volume.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Body {
    /// Its name in the mesh file.
    pub name: String,
    /// Its elements, as a range of [`Mesh::hexes`].
    pub elements: std::ops::Range<usize>,
}

/// A physical surface: outer faces of hexahedra.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Surface {
    /// Its name in the mesh file.
    pub name: String,
    /// Its faces, in the order of the file.
    pub faces: Vec<Face>,
}

/// An outer face of a hexahedron, its nodes counter-clockwise seen from outside the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Face {
    /// Node indices.
    pub nodes: [u32; 4],
    /// The hexahedron it belongs to.
    pub element: u32,
}

impl Mesh {
    /// Index of the body called `name`.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|b| b.name == name)
    }

    /// The surface called `name`.
    pub fn surface(&self, name: &str) -> Option<&Surface> {
        self.surfaces.iter().find(|s| s.name == name)
    }

    /// What `node` hangs on; `None` where it hangs on nothing.
    pub fn hung(&self, node: u32) -> Option<&Hanging> {
        let at = self.hanging.binary_search_by_key(&node, |h| h.node).ok()?;
        self.hanging.get(at)
    }

    /// The body that element `element` belongs to.
    pub fn body_of(&self, element: usize) -> usize {
        self.bodies.partition_point(|b| b.elements.end <= element)
    }

    /// The nodes of the surface called `name`, ascending, each once; none where there is no such surface.
    pub fn nodes_of_surface(&self, name: &str) -> Vec<u32> {
        self.surface(name).map(Surface::nodes).unwrap_or_default()
    }

    /// The nodes of the body with the index `body`, ascending, each once.
    pub fn nodes_of_body(&self, body: usize) -> Vec<u32> {
        let hexes = &self.hexes[self.bodies[body].elements.clone()];
        ascending(hexes.iter().flatten().copied())
    }

    /// Least and largest coordinate of its nodes along an axis.
    pub fn range_along(&self, axis: usize) -> [f64; 2] {
        range(self.points.iter().map(|p| p[axis]))
    }

    /// Length of the box around it along an axis.
    pub fn extent(&self, axis: usize) -> f64 {
        let [low, high] = self.range_along(axis);
        high - low
    }

    /// The largest [`quadrilateral::distortion`] of the faces of element `element`.
    pub fn distortion(&self, element: usize) -> f64 {
        let corners = self.corners(element);
        let faces =
            FACES.map(|face| quadrilateral::distortion(&face.map(|corner| corners[corner])));
        faces.into_iter().fold(0.0, f64::max)
    }

    /// Corner coordinates of element `element`.
    pub fn corners(&self, element: usize) -> [[f64; 3]; 8] {
        self.hexes[element].map(|n| self.points[n as usize])
    }
}

impl Surface {
    /// The body of each of its faces.
    pub fn bodies(&self, mesh: &Mesh) -> impl Iterator<Item = usize> {
        let faces = self.faces.iter();
        faces.map(|face| mesh.body_of(face.element as usize))
    }

    /// The body that it bounds; `None` for a surface without faces.
    pub fn body(&self, mesh: &Mesh) -> Option<usize> {
        self.bodies(mesh).next()
    }

    /// Outward normal at a node times area: the sum of those of its faces, zero where the surface does not have it.
    pub fn area_vector_at(&self, mesh: &Mesh, node: u32) -> Vec3 {
        let faces = self.faces.iter().filter(|face| face.nodes.contains(&node));
        faces.fold([0.0; 3], |sum, face| add(sum, face.area_vector(mesh)))
    }

    /// The nodes of the surface, ascending, each once.
    pub fn nodes(&self) -> Vec<u32> {
        ascending(self.faces.iter().flat_map(|f| f.nodes))
    }
}
