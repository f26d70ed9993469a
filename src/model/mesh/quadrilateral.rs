//! The bilinear quadrilateral: shape functions of a face of a hexahedron, of a facet of a surface.

use crate::ground::geometry::{Vec3, add, cross, norm, scale, sub};

/// Shape functions of the four corners at natural coordinates `s` in [-1, 1]²: each is one at its
/// own corner and zero at the others. The corners run counter-clockwise from (-1, -1).
#[inline]
pub fn shape(s: [f64; 2]) -> [f64; 4] {
    [
        0.25 * (1.0 - s[0]) * (1.0 - s[1]),
        0.25 * (1.0 + s[0]) * (1.0 - s[1]),
        0.25 * (1.0 + s[0]) * (1.0 + s[1]),
        0.25 * (1.0 - s[0]) * (1.0 + s[1]),
    ]
}

/// Derivatives of the shape functions by the two natural coordinates.
#[inline]
pub fn shape_derivatives(s: [f64; 2]) -> [[f64; 4]; 2] {
    let slopes = [
        [s[1] - 1.0, 1.0 - s[1], 1.0 + s[1], -1.0 - s[1]],
        [s[0] - 1.0, -1.0 - s[0], 1.0 + s[0], 1.0 - s[0]],
    ];
    slopes.map(|line| line.map(|slope| 0.25 * slope))
}

/// Derivatives of a nodal vector field by the two natural coordinates; of positions the tangents.
pub fn derivatives(s: [f64; 2], nodal: &[Vec3; 4]) -> [Vec3; 2] {
    shape_derivatives(s).map(|slopes| {
        let mut along = [0.0; 3];
        for (slope, value) in slopes.into_iter().zip(nodal) {
            for i in 0..3 {
                along[i] += slope * value[i];
            }
        }
        along
    })
}

/// Outward normal times area, exact also where it is warped.
pub fn area_vector([a, b, c, d]: &[Vec3; 4]) -> Vec3 {
    scale(cross(sub(*c, *a), sub(*d, *b)), 0.5)
}

/// How far it is from a parallelogram: the difference of its opposite sides over the geometric mean of its two lengths, zero for
/// every parallelogram.
pub fn distortion(corners: &[Vec3; 4]) -> f64 {
    let [along, across] = derivatives([0.0, 0.0], corners).map(norm);
    let [a, b, c, d] = *corners;
    let apart = 0.25 * norm(sub(add(a, c), add(b, d)));
    if apart > 0.0 {
        apart / (along * across).sqrt()
    } else {
        0.0
    }
}

/// Natural coordinates of the corners.
pub const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallelograms_are_not_distorted() {
        let parallelogram = [[0.0; 3], [2.0, 0.0, 0.0], [3.0, 1.0, 0.5], [1.0, 1.0, 0.5]];
        assert_eq!(distortion(&parallelogram), 0.0);
        // A corner of a square aside by a quarter.
        let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.25, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert!((distortion(&square) - 0.118).abs() < 1e-3);
    }

    #[test]
    fn shape_functions_are_one_at_their_corner() {
        for (a, corner) in CORNERS.iter().enumerate() {
            for (b, value) in shape(*corner).iter().enumerate() {
                assert_eq!(*value, if a == b { 1.0 } else { 0.0 });
            }
        }
    }

    #[test]
    fn normal_of_a_tilted_rectangle() {
        let corners = [
            [0.0, 0.0, 0.0],
            [3.0, 0.0, 4.0],
            [3.0, 2.0, 4.0],
            [0.0, 2.0, 0.0],
        ];
        assert_eq!(area_vector(&corners), [-8.0, 0.0, 6.0]);
    }

    #[test]
    fn derivatives_are_the_slopes_of_the_shape_functions() {
        let (at, h) = ([0.3, -0.6], 1e-6);
        let slopes_at = shape_derivatives(at);
        for axis in 0..2 {
            let mut moved = at;
            moved[axis] += h;
            let slopes = shape(moved).into_iter().zip(shape(at));
            for (slope, exact) in slopes.zip(slopes_at[axis]) {
                assert!(((slope.0 - slope.1) / h - exact).abs() < 1e-9);
            }
        }
    }
}
