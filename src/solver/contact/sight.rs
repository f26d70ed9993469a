//! A line of sight: a point of one side, and what it sees of the other along its normal.

use super::facet::interpolate;
use crate::ground::geometry::{Vec3, dot};

/// A point of one side, and the point of the other side that it sees along its normal.
#[derive(Debug, Clone)]
pub struct Sight {
    /// The node of the carrier that looks; `None` for the middle of a facet and for the other side.
    pub node: Option<u32>,
    /// Nodes of the carrier facet at this end or that, with their shape functions.
    pub carrier: ([u32; 4], [f64; 4]),
    /// The same of the opposite facet with the signs of its image, see `Side::signs`; `None` for a
    /// rigid plane.
    pub(super) opposite: Option<([u32; 4], [f64; 4], Vec3)>,
    /// Unit normal from the carrier to the other side.
    pub(super) normal: Vec3,
    /// Undeformed gap, open positive.
    pub gap: f64,
    /// Overlap that flat facets make of round bodies.
    pub sagitta: f64,
}

impl Sight {
    /// From the middle of a facet of the carrier?
    pub fn is_middle(&self) -> bool {
        self.node.is_none() && self.carrier.1 == [0.25; 4]
    }

    /// Where it looks from or at on the carrier, `points` being those of the mesh.
    pub fn place(&self, points: &[Vec3]) -> Vec3 {
        let (nodes, shape) = &self.carrier;
        interpolate(&nodes.map(|node| points[node as usize]), shape)
    }

    /// The gap under the displacements `u`, open positive.
    pub fn gap_at(&self, u: &[[f64; 3]]) -> f64 {
        let at =
            |nodes: &[u32; 4], shape: &[f64; 4]| interpolate(&nodes.map(|n| u[n as usize]), shape);
        let mut moved = at(&self.carrier.0, &self.carrier.1);
        if let Some((nodes, shape, signs)) = &self.opposite {
            let other = at(nodes, shape);
            moved = [0, 1, 2].map(|i| moved[i] - signs[i] * other[i]);
        }
        self.gap - dot(moved, self.normal)
    }
}
