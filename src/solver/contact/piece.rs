//! What one carrier facet gathers from all its overlaps with the other side.

use super::gathered::Gathered;
use super::segment::SegmentPoint;
use crate::ground::geometry::{Vec3, add, scale, sub};

/// The integrals over one carrier facet, as far as the other side covers it.
#[derive(Default)]
pub(super) struct Piece {
    /// With the hat function of each corner.
    pub corners: [Gathered; 4],
    /// ∫ N_a N_b dA: corner a, corner b of the facet itself.
    pub products: [[f64; 4]; 4],
    /// The same with the corners of each facet that lies opposite.
    pub across: Vec<Across>,
    /// ∫ (n_carrier − n_opposite) dA: the direction in which the sides face each other.
    pub facing: Vec3,
}

/// An opposite facet that overlaps a carrier facet.
pub(super) struct Across {
    pub nodes: [u32; 4],
    /// Signs of the facet's image, see `Side::signs`.
    pub signs: Vec3,
    /// ∫ N_a M_b dA: corner a of the carrier facet, corner b of this one.
    pub products: [[f64; 4]; 4],
}

/// A quadrature point, and what is measured there: the vector across the gap, the outward normals of the
/// carrier and of the other side, the stiffness of both in series.
pub(super) struct QuadraturePoint {
    pub point: SegmentPoint,
    pub gap: Vec3,
    pub normals: [Vec3; 2],
    pub stiffness: f64,
}

impl Piece {
    /// Adds a quadrature point.
    pub fn add(&mut self, at: &QuadraturePoint) {
        let SegmentPoint { carrier, area, .. } = at.point;
        let [own, across] = at.normals;
        self.facing = add(self.facing, scale(sub(own, across), area));
        add_products(&mut self.products, &carrier, &carrier, area);
        for (corner, shape) in self.corners.iter_mut().zip(carrier) {
            let weight = shape * area;
            corner.add(&Gathered {
                area: weight,
                normals: at.normals.map(|normal| scale(normal, weight)),
                gap: scale(at.gap, weight),
                stiffness: weight * at.stiffness,
            });
        }
    }

    /// The piece, unless nothing lies opposite.
    pub fn some(self) -> Option<Self> {
        self.corners.iter().any(|c| c.area != 0.0).then_some(self)
    }
}

/// Adds a quadrature point's share of ∫ N_a M_b dA.
#[inline]
pub(super) fn add_products(products: &mut [[f64; 4]; 4], a: &[f64; 4], b: &[f64; 4], area: f64) {
    for (row, a) in products.iter_mut().zip(a) {
        for (value, b) in row.iter_mut().zip(b) {
            *value += area * a * b;
        }
    }
}
