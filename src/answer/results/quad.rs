//! Integrals over bilinear faces in space.

use crate::ground::geometry::{cross, norm, sub};

/// Natural coordinates of the corners of a face.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Points and weights of the three-point Gauss rule.
const GAUSS3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Bilinear shape functions at natural coordinates `xi`.
pub fn shape(xi: [f64; 2]) -> [f64; 4] {
    CORNERS.map(|c| 0.25 * (1.0 + c[0] * xi[0]) * (1.0 + c[1] * xi[1]))
}

/// Derivatives of a nodal vector field by the two natural coordinates.
pub fn derivatives(xi: [f64; 2], nodal: &[[f64; 3]; 4]) -> [[f64; 3]; 2] {
    let mut along = [[0.0; 3]; 2];
    for (c, v) in CORNERS.iter().zip(nodal) {
        let g = [
            0.25 * c[0] * (1.0 + c[1] * xi[1]),
            0.25 * c[1] * (1.0 + c[0] * xi[0]),
        ];
        for (direction, g) in along.iter_mut().zip(g) {
            for i in 0..3 {
                direction[i] += g * v[i];
            }
        }
    }
    along
}

/// Natural coordinates of corner `corner`.
pub fn corner(corner: usize) -> [f64; 2] {
    CORNERS[corner % 4]
}

/// Integrates over a face: `f` gets the shape functions and the area of each of nine points.
///
/// Exact on parallelograms up to degree 5 in each direction.
pub fn integrate(nodes: &[[f64; 3]; 4], mut f: impl FnMut(&[f64; 4], f64)) {
    for (u, wu) in GAUSS3 {
        for (v, wv) in GAUSS3 {
            let [a, b] = derivatives([u, v], nodes);
            f(&shape([u, v]), wu * wv * norm(cross(a, b)));
        }
    }
}

/// Area of a face.
pub fn area(nodes: &[[f64; 3]; 4]) -> f64 {
    let mut sum = 0.0;
    integrate(nodes, |_, area| sum += area);
    sum
}

/// Integral of the unit normal over a face, exact also where the face is warped.
pub fn area_vector(nodes: &[[f64; 3]; 4]) -> [f64; 3] {
    cross(sub(nodes[2], nodes[0]), sub(nodes[3], nodes[1])).map(|x| 0.5 * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TILTED: [[f64; 3]; 4] = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 4.0],
        [3.0, 2.0, 4.0],
        [0.0, 2.0, 0.0],
    ];

    #[test]
    fn area_and_normal_of_a_tilted_rectangle() {
        assert!((area(&TILTED) - 10.0).abs() < 1e-13);
        assert_eq!(area_vector(&TILTED), [-8.0, 0.0, 6.0]);
    }

    #[test]
    fn a_quartic_is_integrated_exactly() {
        let mut sum = 0.0;
        integrate(&TILTED, |n, area| {
            let x: f64 = n.iter().zip(TILTED).map(|(n, p)| n * p[0]).sum();
            sum += x.powi(4) * area;
        });
        assert!((sum - 3f64.powi(4) / 5.0 * 10.0).abs() < 1e-11);
    }
}
