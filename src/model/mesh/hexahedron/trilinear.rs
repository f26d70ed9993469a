//! The trilinear map from natural coordinates to a hexahedron: shape functions, Jacobian.

use super::numbering::CORNERS;
use crate::ground::geometry::{cross, dot};

/// 1/√3: the point number k of the 2×2×2 Gauss rule lies at this share of corner k's natural
/// coordinates, and has weight 1.
pub const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Shape functions at natural coordinates `s` in [-1, 1]³.
#[inline]
pub fn shape(s: [f64; 3]) -> [f64; 8] {
    CORNERS.map(|c| 0.125 * (1.0 + c[0] * s[0]) * (1.0 + c[1] * s[1]) * (1.0 + c[2] * s[2]))
}

/// Derivatives of the shape functions by the three natural coordinates.
#[inline]
pub fn shape_derivatives(s: [f64; 3]) -> [[f64; 3]; 8] {
    CORNERS.map(|c| {
        let f = [1.0 + c[0] * s[0], 1.0 + c[1] * s[1], 1.0 + c[2] * s[2]];
        [
            0.125 * c[0] * f[1] * f[2],
            0.125 * c[1] * f[0] * f[2],
            0.125 * c[2] * f[0] * f[1],
        ]
    })
}

/// The Jacobian matrix ∂x_i/∂ξ_j, row i, from the corners and the derivatives of the shape
/// functions.
#[inline]
pub fn jacobian_matrix(corners: &[[f64; 3]; 8], derivatives: &[[f64; 3]; 8]) -> [[f64; 3]; 3] {
    let mut jacobian = [[0.0; 3]; 3];
    for (x, d) in corners.iter().zip(derivatives) {
        for i in 0..3 {
            for j in 0..3 {
                jacobian[i][j] += x[i] * d[j];
            }
        }
    }
    jacobian
}

/// Determinant of the Jacobian at natural coordinates `s`: volume in space over volume in natural
/// coordinates.
fn jacobian(corners: &[[f64; 3]; 8], s: [f64; 3]) -> f64 {
    let rows = jacobian_matrix(corners, &shape_derivatives(s));
    let [a, b, c] = [0, 1, 2].map(|j| rows.map(|row| row[j]));
    dot(cross(a, b), c)
}

/// Volume that each of the 2×2×2 Gauss points stands for, in the order of the corners: the determinant of the Jacobian,
/// as every weight is one.
pub fn gauss_volumes(corners: &[[f64; 3]; 8]) -> [f64; 8] {
    CORNERS.map(|corner| jacobian(corners, corner.map(|c| c * GAUSS)))
}

/// Volume, exact for the trilinear element; negative for a mirrored one.
pub fn volume(corners: &[[f64; 3]; 8]) -> f64 {
    gauss_volumes(corners).iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_one_at_their_corner() {
        for (a, corner) in CORNERS.iter().enumerate() {
            for (b, value) in shape(*corner).iter().enumerate() {
                assert_eq!(*value, if a == b { 1.0 } else { 0.0 });
            }
        }
    }

    #[test]
    fn the_volumes_of_a_sheared_box_sum_to_its_volume() {
        let corners = CORNERS.map(|c| [2.0 * c[0] + 0.3 * c[2], 0.5 * c[1], c[2]]);
        let sum: f64 = gauss_volumes(&corners).iter().sum();
        assert!((sum - 8.0).abs() < 1e-13);
    }
}
