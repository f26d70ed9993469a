//! How the Mises stress is around the node with the largest one: what tells whether the mesh resolves it.

use std::collections::{BTreeMap, BTreeSet};

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
    /// nodal value there is above that of the node, or the largest of the nodes that share no element with what is
    /// beside an edge is below it, whichever is more. Zero elsewhere.
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
    (peak_node, peak): (usize, f64),
) -> f64 {
    let node = |point: u32| recovered.points.node[point as usize] as usize;
    let value = |point: u32| recovered.mises_nodal[point as usize];
    // Half of the peak is doubt enough: smaller values, which most elements have, are not looked at.
    let least = 0.5 * peak;
    let cells = recovered.points.cells[body.elements.clone()].iter();
    let stressed: Vec<&[u32; 8]> = cells
        .filter(|points| points.iter().any(|point| value(*point) > least))
        .collect();
    let points: BTreeSet<u32> = stressed.iter().copied().flatten().copied().collect();
    let beside: BTreeMap<u32, bool> = (points.iter())
        .map(|point| (*point, edges.are_near(&mesh.points[node(*point)])))
        .collect();
    let reaching = stressed
        .iter()
        .filter(|points| points.iter().any(|point| beside[point]));
    let reaching: Vec<&[u32; 8]> = reaching.copied().collect();
    let around_peak = (reaching.iter().copied())
        .filter(|points| points.iter().any(|point| node(*point) == peak_node))
        .flatten();
    let largest = |points: &mut dyn Iterator<Item = u32>| points.map(value).reduce(f64::max);
    let mut inside = around_peak.copied().filter(|point| beside[point]);
    let Some(inside) = largest(&mut inside) else {
        return 0.0;
    };
    let blurred: BTreeSet<u32> = reaching.iter().copied().flatten().copied().collect();
    let clear = largest(&mut points.difference(&blurred).copied()).unwrap_or(least);
    (inside - peak).max(peak - clear.max(least))
}
