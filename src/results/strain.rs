//! The largest strain: is small-strain theory still fair?

use nalgebra::{Matrix3, SymmetricEigen};

use super::hex::{GaussRule, jacobian};
use crate::mesh::Mesh;

/// The largest principal strain by size at any integration point, and its undeformed position.
///
/// Strains come from the displacements alone: an enhanced element's own modes are not seen.
/// `None` for an empty mesh.
pub fn largest_strain(mesh: &Mesh, displacement: &[[f64; 3]]) -> Option<(f64, [f64; 3])> {
    let rule = GaussRule::new();
    let mut best: Option<(f64, [f64; 3])> = None;
    for (element, nodes) in mesh.hexes.iter().enumerate() {
        let corners = mesh.corners(element);
        let moved = nodes.map(|n| displacement[n as usize]);
        for (point, gradients) in rule.gradients.iter().enumerate() {
            let strain = strain_tensor(gradients, &corners, &moved);
            // The norm bounds every principal value and spares most eigenvalue problems.
            let largest = best.map_or(-1.0, |(value, _)| value);
            if strain.norm() <= largest {
                continue;
            }
            let value = SymmetricEigen::new(strain).eigenvalues.amax();
            if value > largest {
                best = Some((value, rule.position(point, &corners)));
            }
        }
    }
    best
}

/// Small-strain tensor from natural gradients, corner positions and corner displacements; zero in
/// an element without volume.
fn strain_tensor(
    gradients: &[[f64; 3]; 8],
    corners: &[[f64; 3]; 8],
    moved: &[[f64; 3]; 8],
) -> Matrix3<f64> {
    let matrix = |m: [[f64; 3]; 3]| Matrix3::from_fn(|i, j| m[i][j]);
    let Some(inverse) = matrix(jacobian(gradients, corners)).try_inverse() else {
        return Matrix3::zeros();
    };
    let gradient = matrix(jacobian(gradients, moved)) * inverse;
    0.5 * (gradient + gradient.transpose())
}
