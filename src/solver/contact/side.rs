//! One side of a pair: its facets, their images behind mirror planes, its true surface.

use super::facet;
use super::pair::Pair;
use crate::ground::geometry::{Vec3, times};
use crate::model::mesh::shape::{self, Shape};
use crate::model::mesh::{Face, Mesh, Surface};
use crate::solver::fem::hex8::Geometry;

/// One side's facets with what is needed of them at a quadrature point.
#[derive(Clone)]
pub(super) struct Side {
    /// Nodes of each facet, counter-clockwise seen from outside,
    pub nodes: Vec<[u32; 4]>,
    /// their points,
    pub corners: Vec<[Vec3; 4]>,
    /// and the outward unit normal of the facet.
    pub normals: Vec<Vec3>,
    /// Stiffness of the element below each facet, stress per length: E / (1 − ν²) over the element's depth.
    pub stiffness: Vec<f64>,
    /// 1 along each axis, and −1 across the mirror planes behind which a facet is an image.
    pub signs: Vec<Vec3>,
    shape: Shape,
}

impl Side {
    /// The facets of `surface`, one side of `pair`.
    pub fn new(pair: &Pair, surface: &Surface) -> Self {
        let mesh = pair.mesh;
        let faces = &surface.faces;
        let corners: Vec<[Vec3; 4]> = faces.iter().map(|face| face.corners(mesh)).collect();
        let normals = corners
            .iter()
            .map(|c| facet::normal(c).unwrap_or_default())
            .collect();
        let stiffness = faces.iter().zip(&corners).map(|(face, corners)| {
            let thickness = depth(mesh, face, corners);
            pair.moduli[mesh.body_of(face.element as usize)] / thickness
        });
        Self {
            nodes: faces.iter().map(|face| face.nodes).collect(),
            stiffness: stiffness.collect(),
            corners,
            normals,
            signs: vec![[1.0; 3]; faces.len()],
            shape: if pair.true_geometry {
                shape::fit(mesh, surface)
            } else {
                Shape::Facets
            },
        }
    }

    /// Is no true shape known behind the facets?
    pub fn is_flat(&self) -> bool {
        matches!(self.shape, Shape::Facets)
    }

    /// With the images of facets within `distance` of the mirror planes: a carrier facet at the
    /// plane may look across it.
    pub fn with_images(mut self, mirrors: &[usize], distance: f64) -> Self {
        for &axis in mirrors {
            for index in 0..self.nodes.len() {
                let far = |corner: &Vec3| corner[axis].abs() > distance;
                if self.corners[index].iter().all(far) {
                    continue;
                }
                let mut sign = [1.0; 3];
                sign[axis] = -1.0;
                let image = |v: Vec3| times(v, sign);
                // The image runs the other way round.
                let (mut nodes, mut corners) = (self.nodes[index], self.corners[index].map(image));
                nodes.reverse();
                corners.reverse();
                self.nodes.push(nodes);
                self.corners.push(corners);
                self.normals.push(image(self.normals[index]));
                self.stiffness.push(self.stiffness[index]);
                self.signs.push(image(self.signs[index]));
            }
        }
        self
    }

    /// True position and outward normal at shape functions `n` of facet `index`.
    pub fn at(&self, index: usize, n: &[f64; 4]) -> (Vec3, Vec3) {
        let point = facet::interpolate(&self.corners[index], n);
        let signs = self.signs[index];
        let foot = self.shape.project(times(point, signs));
        foot.map_or((point, self.normals[index]), |(foot, normal)| {
            (times(foot, signs), times(normal, signs))
        })
    }
}

/// Depth of the element below a face: its volume over the face's area.
fn depth(mesh: &Mesh, face: &Face, corners: &[Vec3; 4]) -> f64 {
    let element = Geometry::new(&mesh.corners(face.element as usize));
    element.volume / facet::area(corners)
}
