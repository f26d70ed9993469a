//! Integrals with the hat function of one carrier node.

use super::facet::facing;
use crate::ground::geometry::{Vec3, add, norm, scale};

/// ∫ N_A (…) dA over the overlap, N_A being the hat function of one carrier node.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Gathered {
    /// Of 1: the area w_A.
    pub area: f64,
    /// Of the outward unit normals of the carrier and of the other side.
    pub normals: [Vec3; 2],
    /// Of the vector from the carrier's true surface to the other's.
    pub gap: Vec3,
    /// Of the stiffness of both sides in series, stress per length.
    pub stiffness: f64,
}

impl Gathered {
    /// Adds the integrals over another part.
    pub fn add(&mut self, other: &Self) {
        self.area += other.area;
        let [own, across] = self.normals;
        self.normals = [add(own, other.normals[0]), add(across, other.normals[1])];
        self.gap = add(self.gap, other.gap);
        self.stiffness += other.stiffness;
    }

    /// A share of the integrals.
    pub fn times(&self, share: f64) -> Self {
        Self {
            area: share * self.area,
            normals: self.normals.map(|normal| scale(normal, share)),
            gap: scale(self.gap, share),
            stiffness: share * self.stiffness,
        }
    }

    /// The direction of the contact normal, from the carrier to the other side, see [`facing`]. The mean over a curved side
    /// leans where nodes do not lie evenly about the line of contact, and the contact force would lean with it.
    pub fn normal(&self) -> Vec3 {
        /// A side is flat where the mean of its unit normals is shorter than one by no more than this: rounding.
        const ROUNDING: f64 = 1e-10;
        let flat = |normal: Vec3| norm(normal) >= (1.0 - ROUNDING) * self.area;
        facing(self.normals, self.normals.map(flat))
    }
}
