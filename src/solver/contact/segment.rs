//! Where a carrier facet and an opposite facet overlap: quadrature points on both.
//!
//! Both facets are projected along one direction, their overlap is cut into triangles, and each
//! triangle gets a Gauss rule (Puso and Laursen, CMAME 193 (2004) 601). On parallelograms the products of two
//! bilinear shape functions are integrated exactly.

use super::clip::{self, Point};
use super::facet::shape_at;
use super::gauss::{self, RulePoint};
use crate::ground::geometry::{Vec3, add, dot, scale, sub, tangents};

/// A point of a segment.
#[derive(Debug, Clone, Copy)]
pub(super) struct SegmentPoint {
    /// Shape functions of the carrier facet,
    pub carrier: [f64; 4],
    /// and of the opposite facet; zero before a rigid plane.
    pub opposite: [f64; 4],
    /// Area that the point stands for, measured on the carrier facet.
    pub area: f64,
}

/// A carrier facet, seen along the direction in which it is projected.
pub(super) struct View {
    origin: Vec3,
    axes: [Vec3; 2],
    corners: [Point; 4],
    /// Area of the facet's own plane over that of its view.
    stretch: f64,
    /// How far the view is from a parallelogram, where integrals are to be right to rounding.
    distortion: Option<f64>,
}

/// An overlap of no more than this share of the facet is rounding along a common edge.
const ROUNDING: f64 = 1e-12;

/// Degree-4 rule on a triangle (Dunavant, IJNME 21 (1985) 1129): barycentric coordinates and weights.
const RULE: [([f64; 3], f64); 6] = {
    const A: f64 = 0.445_948_490_915_965;
    const B: f64 = 0.091_576_213_509_771;
    const C: f64 = 1.0 - 2.0 * A;
    const D: f64 = 1.0 - 2.0 * B;
    const V: f64 = 0.223_381_589_678_011;
    const W: f64 = 0.109_951_743_655_322;
    [
        ([A, A, C], V),
        ([A, C, A], V),
        ([C, A, A], V),
        ([B, B, D], W),
        ([B, D, B], W),
        ([D, B, B], W),
    ]
};

impl View {
    /// Of a facet with the unit normal `normal` along the unit vector `direction`, which must not
    /// lie in the facet.
    pub fn new(facet: &[Vec3; 4], normal: Vec3, direction: Vec3) -> Self {
        let origin = scale(facet.iter().fold([0.0; 3], |sum, p| add(sum, *p)), 0.25);
        let mut view = Self {
            origin,
            axes: tangents(direction),
            corners: [[0.0; 2]; 4],
            stretch: dot(normal, direction).recip(),
            distortion: None,
        };
        view.corners = facet.map(|p| view.project(p));
        view
    }

    /// To rounding where facets are no parallelograms, too.
    pub fn closely(mut self) -> Self {
        self.distortion = Some(gauss::distortion(&self.corners));
        self
    }

    fn project(&self, p: Vec3) -> Point {
        let r = sub(p, self.origin);
        [dot(r, self.axes[0]), dot(r, self.axes[1])]
    }

    /// Hands on the quadrature points of the overlap with `opposite`, whose normal faces the
    /// carrier's.
    pub fn overlap(&self, opposite: &[Vec3; 4], each: impl FnMut(SegmentPoint)) {
        let window = opposite.map(|p| self.project(p));
        // Seen from the carrier the opposite facet runs clockwise.
        let mut turned = window;
        turned.reverse();
        let polygon = clip::intersect(&self.corners, &turned);
        let facet_area = clip::area(&self.corners);
        if polygon.is_empty() || clip::area(&polygon) <= ROUNDING * facet_area {
            return;
        }
        let rule = (self.distortion)
            .and_then(|own| gauss::close(own.max(gauss::distortion(&window))))
            .unwrap_or(&RULE);
        self.points((&polygon, rule), |p| shape_at(&window, p), each);
    }

    /// Hands on the quadrature points of the whole facet; the opposite shape functions are zero.
    pub fn whole(&self, each: impl FnMut(SegmentPoint)) {
        self.points((&self.corners, &RULE), |_| Some([0.0; 4]), each);
    }

    fn points(
        &self,
        (polygon, rule): (&[Point], &[RulePoint]),
        opposite: impl Fn(Point) -> Option<[f64; 4]>,
        mut each: impl FnMut(SegmentPoint),
    ) {
        let count = polygon.len() as f64;
        let centre = polygon.iter().fold([0.0; 2], |sum, p| {
            [sum[0] + p[0] / count, sum[1] + p[1] / count]
        });
        for (k, a) in polygon.iter().enumerate() {
            let b = polygon[(k + 1) % polygon.len()];
            let area = clip::area(&[centre, *a, b]);
            for &(l, weight) in rule {
                let p = [
                    l[0] * centre[0] + l[1] * a[0] + l[2] * b[0],
                    l[0] * centre[1] + l[1] * a[1] + l[2] * b[1],
                ];
                if let (Some(carrier), Some(opposite)) = (shape_at(&self.corners, p), opposite(p)) {
                    each(SegmentPoint {
                        carrier,
                        opposite,
                        area: self.stretch * weight * area,
                    });
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_offset_overlap_integrates_products_of_shape_functions_exactly() {
        // Carrier looks up (+z), the opposite facet down; overlap is [0.25, 1] x [0, 1].
        let carrier = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        let opposite = [
            [0.25, 0.0, 0.1],
            [0.25, 1.0, 0.1],
            [1.25, 1.0, 0.1],
            [1.25, 0.0, 0.1],
        ];
        let up = [0.0, 0.0, 1.0];
        let mut points = Vec::new();
        View::new(&carrier, up, up).overlap(&opposite, |p| points.push(p));
        let area: f64 = points.iter().map(|p| p.area).sum();
        assert!((area - 0.75).abs() < 1e-14);
        // ∫ (1-x)(1-y) * (1-(x-0.25))(1-y) over the overlap; the y part is 1/3.
        let f = |x: f64| 1.25 * x - 1.125 * x * x + x.powi(3) / 3.0;
        let exact = (f(1.0) - f(0.25)) / 3.0;
        let sum: f64 = points
            .iter()
            .map(|p| p.area * p.carrier[0] * p.opposite[0])
            .sum();
        assert!((sum - exact).abs() < 1e-14, "{sum} {exact}");
    }
    #[test]
    fn area_is_measured_on_the_facet_whatever_the_view() {
        let facet = [
            [0.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [2.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        let view = View::new(&facet, [0.0, 0.0, 1.0], [0.6, 0.0, 0.8]);
        let mut area = 0.0;
        view.whole(|p| area += p.area);
        assert!((area - 2.0).abs() < 1e-14, "{area}");
    }
}
