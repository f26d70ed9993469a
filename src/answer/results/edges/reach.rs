//! How far the stress of a singular edge reaches.

use super::super::hex::distance;
use crate::ground::geometry::{dot, sub, unit};
use crate::model::mesh::{Face, Mesh};

/// Nodes on singular edges.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct EdgeNodes(Vec<EdgeNode>);

#[derive(Debug, Clone, Copy, PartialEq)]
struct EdgeNode {
    at: [f64; 3],
    /// Of the surface there; unit length.
    normal: [f64; 3],
    /// How far the stress of the edge reaches along the surface, and as far below it.
    reach: f64,
    /// Is the face longer than that? Then it is the face that says how far.
    is_coarse: bool,
}

/// Nodes that a mesh puts where an edge ceases to reach are no longer near it, by rounding or a roller a little askew.
const SLACK: f64 = 0.01;

impl EdgeNodes {
    /// Adds the ends of side `side` of a face, whose stress reaches as far as `whole`, a length. A face that is longer
    /// belongs to its edge as a whole.
    pub fn add(&mut self, mesh: &Mesh, face: &Face, side: usize, whole: f64) {
        let Some(normal) = unit(face.area_vector(mesh)) else {
            return;
        };
        let mut corners = face.corners(mesh);
        corners.rotate_left(side);
        let [a, b, c, d] = corners;
        let is_coarse = distance(a, d).max(distance(b, c)) > (1.0 + SLACK) * whole;
        let reach = if is_coarse { distance(a, c) } else { whole };
        self.0.extend([a, b].map(|at| EdgeNode {
            at,
            normal,
            reach,
            is_coarse,
        }));
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Is a point so near to an edge that its stress belongs to the edge?
    pub fn are_near(&self, at: &[f64; 3]) -> bool {
        self.0.iter().any(|edge| edge.reaches(at))
    }

    /// Does an edge cease to reach just there?
    pub fn end_at(&self, at: &[f64; 3]) -> bool {
        self.0.iter().any(|edge| edge.ends_at(at))
    }

    /// Is a point so near to an edge whose faces are longer than its stress reaches that it belongs to these?
    pub fn are_coarsely_near(&self, at: &[f64; 3]) -> bool {
        self.0.iter().any(|edge| edge.is_coarse && edge.reaches(at))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_reaches_as_far_along_the_surface_as_below_it() {
        let edge = EdgeNode {
            at: [1.0, 2.0, 3.0],
            normal: [0.0, 0.0, 1.0],
            reach: 0.5,
            is_coarse: false,
        };
        let beside = |x: f64, z: f64| edge.reaches(&[1.0 + x, 2.0, 3.0 + z]);
        assert!(beside(0.49, 0.0) && beside(-0.49, -0.49) && beside(0.0, -0.5));
        // The plane of nodes where it ends, moved by rounding, and what lies deeper.
        let ends = |x: f64, z: f64| edge.ends_at(&[1.0 + x, 2.0, 3.0 + z]);
        assert!(ends(0.5, -0.1) && ends(-0.499, 0.0) && !ends(0.48, 0.0) && !ends(0.52, 0.0));
        assert!(!beside(0.5, 0.0) && !beside(0.499, -0.2) && !beside(0.0, -0.51));
    }
}
