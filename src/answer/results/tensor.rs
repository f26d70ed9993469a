//! Symmetric stress tensors in the order xx yy zz xy yz zx.

use crate::ground::geometry::{Vec3, dot};
use crate::model::material::matrix;
pub use crate::model::material::mises;

/// Mean of several stress tensors; zero for none.
pub fn mean(tensors: &[[f64; 6]]) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for tensor in tensors {
        for (s, t) in sum.iter_mut().zip(tensor) {
            *s += t;
        }
    }
    sum.map(|s| s / tensors.len().max(1) as f64)
}

/// The traction on a plane with the unit normal `n`.
pub fn traction(stress: &[f64; 6], n: Vec3) -> Vec3 {
    matrix(*stress).map(|row| dot(row, n))
}

/// The components xx yy zz xy yz zx of a symmetric tensor.
pub fn tensor_of(component: impl Fn(usize, usize) -> f64) -> [f64; 6] {
    [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| component(i, j))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mises_of_uniaxial_shear_and_hydrostatic_stress() {
        assert_eq!(mises(&[0.0, -7.0, 0.0, 0.0, 0.0, 0.0]), 7.0);
        assert!((mises(&[0.0, 0.0, 0.0, 0.0, 2.0, 0.0]) - 12f64.sqrt()).abs() < 1e-14);
        assert_eq!(mises(&[3.0, 3.0, 3.0, 0.0, 0.0, 0.0]), 0.0);
    }

    #[test]
    fn the_traction_on_a_plane_is_a_column_of_the_stress() {
        let stress = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        assert_eq!(traction(&stress, [1.0, 0.0, 0.0]), [1.0, 4.0, 6.0]);
        assert_eq!(traction(&stress, [0.0, 1.0, 0.0]), [4.0, 2.0, 5.0]);
        assert_eq!(traction(&stress, [0.0, 0.0, 1.0]), [6.0, 5.0, 3.0]);
    }

    #[test]
    fn the_mean_is_taken_component_by_component() {
        let mean = mean(&[
            [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            [3.0, 2.0, 1.0, 0.0, 1.0, 2.0],
        ]);
        assert_eq!(mean, [2.0, 2.0, 2.0, 2.0, 3.0, 4.0]);
    }
}
