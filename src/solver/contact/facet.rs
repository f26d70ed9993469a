//! A facet: the bilinear quadrilateral that four nodes of a surface span.

use super::clip::Point;
use crate::ground::geometry::{Vec3, add, cross, dot, norm, scale, sub, tangents, unit};
use crate::model::mesh::quadrilateral;

/// Cosine between the outward normals of two facets that face each other, at most: beyond 107 degrees. Facets
/// that stand flatter to each other than that lie on a rim, and press on nothing.
pub(super) const MOST_FACING: f64 = -0.3;

/// Unit normal of a facet's mean plane; `None` for a facet without area.
pub(super) fn normal(facet: &[Vec3; 4]) -> Option<Vec3> {
    unit(cross(sub(facet[2], facet[0]), sub(facet[3], facet[1])))
}

/// The direction from one side to the other, of their outward normals and whether each is flat there: where exactly one is,
/// the normal of that side, which is known to the last digit and stays what it is as the other side slides; elsewhere the mean
/// of both, not normalised.
pub(super) fn facing([own, across]: [Vec3; 2], is_flat: [bool; 2]) -> Vec3 {
    match is_flat {
        [true, false] => own,
        [false, true] => scale(across, -1.0),
        _ => sub(own, across),
    }
}

/// Area of a facet.
pub(super) fn area([a, b, c, d]: &[Vec3; 4]) -> f64 {
    0.5 * norm(cross(sub(*c, *a), sub(*d, *b)))
}

/// Point of a facet with the given shape functions; of displacements likewise.
#[inline]
pub(super) fn interpolate(facet: &[Vec3; 4], shape: &[f64; 4]) -> Vec3 {
    facet
        .iter()
        .zip(shape)
        .fold([0.0; 3], |sum, (p, n)| add(sum, scale(*p, *n)))
}

/// Shape functions of a facet where the line through `p` along the unit vector `direction` meets it;
/// `None` where it does not.
pub(super) fn meets(facet: &[Vec3; 4], p: Vec3, direction: Vec3) -> Option<[f64; 4]> {
    /// How far a shape function may fall below zero, which says that the line passes the facet
    /// outside an edge: no farther than rounding moves it.
    const OUTSIDE: f64 = 1e-6;
    let axes = tangents(direction);
    let seen = facet.map(|corner| axes.map(|axis| dot(sub(corner, p), axis)));
    let shape = shape_at(&seen, [0.0; 2])?;
    shape.iter().all(|n| *n >= -OUTSIDE).then_some(shape)
}

/// Shape functions of the plane quadrilateral `corners` at its point `p`: the natural coordinates
/// of the point by Newton's method. `None` where it runs away, far outside.
#[inline]
pub(super) fn shape_at(corners: &[Point; 4], p: Point) -> Option<[f64; 4]> {
    const ITERATIONS: usize = 20;
    /// Natural coordinates beyond which the point is given up; those of the facet end at 1.
    const FAR_OUTSIDE: f64 = 10.0;
    /// A step this short is rounding.
    const STEP: f64 = 1e-14;
    let mut s = [0.0; 2];
    for _ in 0..ITERATIONS {
        let n = quadrilateral::shape(s);
        let dn = quadrilateral::shape_derivatives(s);
        let (mut r, mut j) = ([-p[0], -p[1]], [[0.0; 2]; 2]);
        for (k, c) in corners.iter().enumerate() {
            for i in 0..2 {
                r[i] += n[k] * c[i];
                j[i][0] += dn[0][k] * c[i];
                j[i][1] += dn[1][k] * c[i];
            }
        }
        let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
        let step = [
            (j[1][1] * r[0] - j[0][1] * r[1]) / det,
            (j[0][0] * r[1] - j[1][0] * r[0]) / det,
        ];
        s = [s[0] - step[0], s[1] - step[1]];
        if !(s[0].abs() < FAR_OUTSIDE && s[1].abs() < FAR_OUTSIDE) {
            return None;
        }
        if step[0].abs() + step[1].abs() < STEP {
            return Some(quadrilateral::shape(s));
        }
    }
    Some(quadrilateral::shape(s))
}
