//! The stress at a node as the means of the elements around it have it.
//!
//! Slopes within trilinear elements are wrong at a surface: what they extrapolate to its nodes is off by the first order of
//! the spacing, by the same in all of them, so that these do not differ. Slopes from element to element are right. Means
//! are taken as stresses of element centres, and a linear function is fitted to those of two rings of elements around the
//! node (as in the recovery from patches of Zienkiewicz and Zhu, Int. J. Numer. Meth. Engng 33 (1992) 1331).

use super::recovery::{Recovered, mirrored};
use super::tensor::mises;
use crate::ground::geometry::{Vec3, sub};
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use std::collections::BTreeSet;

/// Variance of places along a direction, over the squares of the sizes of elements, below which nothing is known of a slope
/// along it: that of two elements side by side is a quarter.
const LEAST_VARIANCE: f64 = 0.1;

/// An element, or its image beside a mirror plane.
struct Mean {
    /// Its centre from the node on, over the sizes of elements there.
    at: Vector3<f64>,
    stress: [f64; 6],
    /// Does it meet the node?
    is_own: bool,
}

/// The Mises stress at a `node` of `body`, the elements `own` of which meet there and reach as far as `extent`.
pub(super) fn mises_of_means(
    (scene, body): (&Scene, &Body),
    (state, recovered): (&State, &Recovered),
    node: usize,
    (own, extent): (&[usize], &Vec3),
) -> f64 {
    let means = means((scene, body), (state, recovered), node, (own, extent));
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
    mises(&stress.into())
}

/// Two rings of elements around the node, with their images beside the mirror planes through it.
fn means(
    (scene, body): (&Scene, &Body),
    (state, recovered): (&State, &Recovered),
    node: usize,
    (own, extent): (&[usize], &Vec3),
) -> Vec<Mean> {
    let node_of = |point: &u32| recovered.points.node[*point as usize];
    let nodes = |element: usize| recovered.points.cells[element].iter().map(node_of);
    let ring: BTreeSet<u32> = own.iter().flat_map(|element| nodes(*element)).collect();
    let near = (body.elements.clone()).filter(|element| nodes(*element).any(|n| ring.contains(&n)));
    let of_eighth = |all: &mut dyn Iterator<Item = f64>| all.sum::<f64>() / 8.0;
    let mean = |element: usize| {
        let corners = scene.mesh.corners(element);
        let centre = [0, 1, 2].map(|k| of_eighth(&mut corners.iter().map(|corner| corner[k])));
        let off = sub(centre, scene.mesh.points[node]);
        let points = &state.stress[element];
        let of_component = |k| of_eighth(&mut points.iter().map(|stress| stress[k]));
        Mean {
            at: Vector3::from_fn(|k, _| off[k] / extent[k]),
            stress: std::array::from_fn(of_component),
            is_own: own.contains(&element),
        }
    };
    let mut means: Vec<Mean> = near.map(mean).collect();
    for axis in scene.mirrors_through(&scene.mesh.points[node]) {
        let image = |mean: &Mean| {
            let mut at = mean.at;
            at[axis] = -at[axis];
            Mean {
                at,
                stress: mirrored(mean.stress, axis),
                is_own: mean.is_own,
            }
        };
        let images: Vec<Mean> = means.iter().map(image).collect();
        means.extend(images);
    }
    means
}
