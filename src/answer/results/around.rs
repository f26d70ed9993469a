//! How the Mises stress is around the node with the largest one: what tells whether the mesh resolves it.

use std::collections::BTreeSet;

use super::edges::LoadedEdges;
use super::hex::GaussRule;
use super::recovery::Recovered;
use super::tensor::mises;
use crate::model::mesh::{Body, Mesh};
use crate::model::state::State;

/// How the Mises stress is around a node with the largest one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Around {
    /// By how much the largest value that an element extrapolates to the node exceeds the average there; zero where only one
    /// element meets there.
    pub jump: f64,
    /// By how much the smallest nodal value of these elements is below that of the node.
    pub fall: f64,
    /// Of a peak away from loaded edges, where one of these elements reaches beside an edge: by how much the largest
    /// nodal value there is above that of the node. Zero elsewhere.
    pub border: f64,
}

/// What is around the nodal peak of `body`, a node and its value, wherever loaded edges are.
pub(super) fn around(
    body: &Body,
    state: &State,
    recovered: &Recovered,
    rule: &GaussRule,
    (node, peak): (usize, f64),
) -> Around {
    let is_at_node = |point: &u32| recovered.points.node[*point as usize] as usize == node;
    let (mut largest, mut smallest) = (peak, peak);
    for element in body.elements.clone() {
        let points = &recovered.points.cells[element];
        let Some(corner) = points.iter().position(is_at_node) else {
            continue;
        };
        largest = largest.max(mises(&rule.extrapolate(&state.stress[element])[corner]));
        let nodal = points.iter().map(|p| recovered.mises_nodal[*p as usize]);
        smallest = nodal.fold(smallest, f64::min);
    }
    Around {
        jump: largest - peak,
        fall: peak - smallest,
        border: 0.0,
    }
}

/// [`Around::border`] of the nodal peak of `body` away from `edges`, a node and its value.
pub(super) fn border(
    mesh: &Mesh,
    body: &Body,
    recovered: &Recovered,
    edges: &LoadedEdges,
    (node, peak): (usize, f64),
) -> f64 {
    let node_of = |point: &u32| recovered.points.node[*point as usize] as usize;
    let cells = recovered.points.cells[body.elements.clone()].iter();
    let around = cells.filter(|points| points.iter().any(|point| node_of(point) == node));
    let points = around.flatten().collect::<BTreeSet<_>>().into_iter();
    let beside = points.filter(|point| edges.are_near(&mesh.points[node_of(point)]));
    let values = beside.map(|point| recovered.mises_nodal[*point as usize]);
    values.fold(0.0, |largest: f64, value| largest.max(value - peak))
}
