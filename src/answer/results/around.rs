//! How the Mises stress is around the node with the largest one: what tells whether the mesh resolves it.

use super::curvature::{Curvature, curvature};
use super::hex::GaussRule;
use super::means::stress_of_means;
use super::recovery::Recovered;
use super::tensor::mises;
use crate::ground::geometry::Vec3;
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;

/// How the Mises stress is around a node with the largest one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Around {
    /// By how much the largest value that an element extrapolates to the node exceeds the average there; zero where only one
    /// element meets there.
    pub jump: f64,
    /// How far the stress that the means of the elements around tend to is from that of the node: by Mises stress, or by most of
    /// the Mises stress of the difference if that is more.
    pub means: f64,
    /// By how much the smallest nodal value of these elements is below that of the node.
    pub fall: f64,
    /// Of a peak away from loaded edges, where one of these elements reaches beside an edge: by how much the largest
    /// nodal value there is above that of the node. Zero elsewhere.
    pub border: f64,
    /// Is one of these elements beside a singular edge whose faces are longer than its stress reaches, and the stress larger there?
    pub rises_to_long_faces: bool,
    /// What is between the nodal value and the stress itself.
    pub curvature: Curvature,
    /// Are they far from parallelepipeds, see [`IRREGULAR`]?
    pub is_irregular: bool,
}

/// [Distortion](crate::model::mesh::quadrilateral::distortion) from which on elements are no part of a grid: of graded grids and of those
/// around rollers it is below 0.01, of unstructured meshes 0.1 to 0.4.
pub const IRREGULAR: f64 = 0.05;

/// Share of the Mises stress of the difference of two stresses that counts as the distance of their Mises stresses where these are
/// nearer: where stresses superpose, such as pressure in a tube with tension along it, two stresses that are both wrong may have
/// the same Mises stress by chance. (Of 199 drawn tubes under pressure within, without and along them 23 were outside their
/// bars without it, 5 are with it, all of them with two elements through the wall.)
const APART: f64 = 0.6;

fn apart(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let difference = std::array::from_fn(|k| a[k] - b[k]);
    (mises(a) - mises(b)).abs().max(APART * mises(&difference))
}

/// What is around the nodal peak of `body`, a node and its value; `is_beside` tells which places are beside an edge,
/// and `is_coarse` which beside one whose faces are longer than its stress reaches.
pub(super) fn around(
    (scene, body): (&Scene, &Body),
    state: &State,
    recovered: &Recovered,
    rule: &GaussRule,
    (node, peak): (usize, f64),
    (is_beside, is_coarse): (impl Fn(&Vec3) -> bool, impl Fn(&Vec3) -> bool),
) -> Around {
    let node_of = |point: u32| recovered.points.node[point as usize] as usize;
    let corner_at_node = |element: usize| {
        let points = &recovered.points.cells[element];
        let corner = points.iter().position(|point| node_of(*point) == node)?;
        Some((element, corner))
    };
    let elements: Vec<(usize, usize)> = body.elements.clone().filter_map(corner_at_node).collect();
    let (mut extrapolated, mut smallest, mut beside) = (peak, peak, peak);
    let mut rises_to_long_faces = false;
    for (element, corner) in &elements {
        let at_node = mises(&rule.extrapolate(&state.stress[*element])[*corner]);
        extrapolated = extrapolated.max(at_node);
        for point in &recovered.points.cells[*element] {
            let value = recovered.mises_nodal[*point as usize];
            smallest = smallest.min(value);
            let at = &scene.mesh.points[node_of(*point)];
            if is_beside(at) {
                beside = beside.max(value);
            }
            rises_to_long_faces |= value > peak && is_coarse(at);
        }
    }
    let at_node = elements.first().map(|(element, corner)| {
        let point = recovered.points.cells[*element][*corner];
        recovered.nodal_stress[point as usize]
    });
    let own: Vec<usize> = elements.iter().map(|(element, _)| *element).collect();
    let of_means = stress_of_means((scene, body), (state, recovered), node, &own);
    Around {
        jump: extrapolated - peak,
        means: of_means.zip(at_node).map_or(0.0, |(a, b)| apart(&a, &b)),
        fall: peak - smallest,
        border: beside - peak,
        rises_to_long_faces,
        curvature: curvature(scene, recovered, &elements, is_beside),
        is_irregular: own
            .iter()
            .any(|element| scene.mesh.distortion(*element) > IRREGULAR),
    }
}
