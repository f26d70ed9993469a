//! Integrals over bilinear faces in space.

use crate::ground::geometry::{cross, norm};
use crate::model::mesh::quadrilateral::{derivatives, shape};

/// Points and weights of the three-point Gauss rule.
const GAUSS3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

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
    fn area_of_a_tilted_rectangle() {
        assert!((area(&TILTED) - 10.0).abs() < 1e-13);
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
