//! The stress at a node as the means of the elements around it have it.
//!
//! Slopes within trilinear elements are wrong at a surface: what they extrapolate to its nodes is off by the first order of
//! the spacing, by the same in all of them, so that these do not differ. Slopes from element to element are right. Means
//! are taken as stresses of element centres, and a linear function is fitted to those of two rings of elements around the
//! node (as in the recovery from patches of Zienkiewicz and Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331).

use super::recovery::{Recovered, mirrored};
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use std::collections::BTreeSet;

/// Variance of the centres of elements along a direction, over that of the corners of one element, below which nothing is known
/// of a slope along it: that of two elements side by side is one, that of a single layer nothing.
const LEAST_VARIANCE: f64 = 0.4;

/// An element, or its image beside a mirror plane.
struct Mean {
    /// Its centre from the node on, in coordinates in which the corners of elements there vary by one in every direction:
    /// slopes are then known as well in any orientation, and along the short side of an element as along the long one.
    at: Vector3<f64>,
    stress: [f64; 6],
    /// Does it meet the node?
    is_own: bool,
}

/// The stress at a `node` of `body`, the elements `own` of which meet there; `None` where these have no volume.
pub(super) fn stress_of_means(
    (scene, body): (&Scene, &Body),
    (state, recovered): (&State, &Recovered),
    node: usize,
    own: &[usize],
) -> Option<[f64; 6]> {
    let means = means((scene, body), (state, recovered), node, own)?;
    let count = means.len() as f64;
    let middle: Vector3<f64> = means.iter().map(|mean| mean.at).sum::<Vector3<f64>>() / count;
    let (mut variance, mut along) = (Matrix3::zeros(), SMatrix::<f64, 3, 6>::zeros());
    for mean in &means {
        let off = mean.at - middle;
        variance += off * off.transpose() / count;
        along += off * SVector::from(mean.stress).transpose() / count;
    }
    let eigen = variance.symmetric_eigen();
    let mut slopes = SMatrix::<f64, 3, 6>::zeros();
    for (direction, variance) in eigen.eigenvectors.column_iter().zip(&eigen.eigenvalues) {
        if *variance >= LEAST_VARIANCE {
            slopes += direction * (direction.transpose() * along) / *variance;
        }
    }
    let at_node = |mean: &Mean| SVector::from(mean.stress) - slopes.transpose() * mean.at;
    let there: Vec<_> = (means.iter().filter(|mean| mean.is_own))
        .map(at_node)
        .collect();
    let stress = there.iter().sum::<SVector<f64, 6>>() / there.len() as f64;
    Some(stress.into())
}

/// Two rings of elements around the node, with their images beside the mirror planes through it.
fn means(
    (scene, body): (&Scene, &Body),
    (state, recovered): (&State, &Recovered),
    node: usize,
    own: &[usize],
) -> Option<Vec<Mean>> {
    let node_of = |point: &u32| recovered.points.node[*point as usize];
    let nodes = |element: usize| recovered.points.cells[element].iter().map(node_of);
    let ring: BTreeSet<u32> = own.iter().flat_map(|element| nodes(*element)).collect();
    let near = (body.elements.clone()).filter(|element| nodes(*element).any(|n| ring.contains(&n)));
    let corners = |element: usize| scene.mesh.corners(element).map(Vector3::from);
    let centre = |element: usize| corners(element).iter().sum::<Vector3<f64>>() / 8.0;
    let mean = |element: usize| {
        let points = state.stress[element].iter();
        let sum: SVector<f64, 6> = points.map(|stress| SVector::from(*stress)).sum();
        Mean {
            at: centre(element) - Vector3::from(scene.mesh.points[node]),
            stress: (sum / 8.0).into(),
            is_own: own.contains(&element),
        }
    };
    let mut means: Vec<Mean> = near.map(mean).collect();
    let off = |element: &usize| {
        let centre = centre(*element);
        corners(*element).map(|corner| corner - centre)
    };
    let mut corners: Vec<Vector3<f64>> = own.iter().flat_map(off).collect();
    for axis in scene.mirrors_through(&scene.mesh.points[node]) {
        let across = |mut at: Vector3<f64>| {
            at[axis] = -at[axis];
            at
        };
        let image = |mean: &Mean| Mean {
            at: across(mean.at),
            stress: mirrored(mean.stress, axis),
            is_own: mean.is_own,
        };
        means.extend(means.iter().map(image).collect::<Vec<_>>());
        corners.extend(corners.iter().copied().map(across).collect::<Vec<_>>());
    }
    let spread: Matrix3<f64> = corners.iter().map(|off| off * off.transpose()).sum();
    let unit = (spread / corners.len() as f64).cholesky()?.l();
    for mean in &mut means {
        mean.at = unit.solve_lower_triangular(&mean.at)?;
    }
    Some(means)
}
