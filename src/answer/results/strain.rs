//! The largest strain: is small-strain theory still fair?

use nalgebra::{Matrix3, SymmetricEigen};
use rayon::prelude::*;

use super::hex::GaussRule;
use crate::model::mesh::Mesh;
use crate::model::mesh::hexahedron::jacobian_matrix;

/// The largest principal strain by size at any integration point, and its undeformed position.
///
/// Strains come from the displacements alone: an enhanced element's own modes are not seen.
/// `None` for an empty mesh.
pub fn largest_strain(mesh: &Mesh, displacement: &[[f64; 3]]) -> Option<(f64, [f64; 3])> {
    // Runs of elements in parallel, then the runs in order: of equal values the first counts.
    const RUN: usize = 1 << 15;
    let rule = GaussRule::new();
    let runs: Vec<_> = mesh
        .hexes
        .par_chunks(RUN)
        .enumerate()
        .map(|(run, hexes)| largest_of(&rule, mesh, displacement, run * RUN, hexes.len()))
        .collect();
    let larger = |a: (f64, [f64; 3]), b: (f64, [f64; 3])| if b.0 > a.0 { b } else { a };
    runs.into_iter().flatten().reduce(larger)
}

/// The same over `count` elements from `first` on.
fn largest_of(
    rule: &GaussRule,
    mesh: &Mesh,
    displacement: &[[f64; 3]],
    first: usize,
    count: usize,
) -> Option<(f64, [f64; 3])> {
    let mut best: Option<(f64, [f64; 3])> = None;
    for element in first..first + count {
        let corners = mesh.corners(element);
        let moved = mesh.hexes[element].map(|n| displacement[n as usize]);
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

/// Strain xx yy zz xy yz zx of the displacements, with engineering shears, from natural gradients, positions and
/// displacements of the corners.
pub fn strain(
    gradients: &[[f64; 3]; 8],
    corners: &[[f64; 3]; 8],
    moved: &[[f64; 3]; 8],
) -> [f64; 6] {
    let e = strain_tensor(gradients, corners, moved);
    let shears = [e[(0, 1)], e[(1, 2)], e[(2, 0)]].map(|shear| 2.0 * shear);
    [
        e[(0, 0)],
        e[(1, 1)],
        e[(2, 2)],
        shears[0],
        shears[1],
        shears[2],
    ]
}

/// Small-strain tensor from natural gradients, corner positions and corner displacements; zero in
/// an element without volume.
fn strain_tensor(
    gradients: &[[f64; 3]; 8],
    corners: &[[f64; 3]; 8],
    moved: &[[f64; 3]; 8],
) -> Matrix3<f64> {
    let matrix = |m: [[f64; 3]; 3]| Matrix3::from_fn(|i, j| m[i][j]);
    let Some(inverse) = matrix(jacobian_matrix(corners, gradients)).try_inverse() else {
        return Matrix3::zeros();
    };
    let gradient = matrix(jacobian_matrix(moved, gradients)) * inverse;
    0.5 * (gradient + gradient.transpose())
}
