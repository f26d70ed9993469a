//! How the Mises stress is around the node with the largest one: what tells whether the mesh resolves it.

use super::hex::GaussRule;
use super::recovery::Recovered;
use super::tensor::mises;
use crate::model::mesh::Body;
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

/// What is around the nodal peak of `body`, a node and its value; `is_beside` tells which nodes are beside an edge.
pub(super) fn around(
    body: &Body,
    state: &State,
    recovered: &Recovered,
    rule: &GaussRule,
    (node, peak): (usize, f64),
    is_beside: impl Fn(usize) -> bool,
) -> Around {
    let node_of = |point: u32| recovered.points.node[point as usize] as usize;
    let (mut extrapolated, mut smallest, mut beside) = (peak, peak, peak);
    for element in body.elements.clone() {
        let points = &recovered.points.cells[element];
        let Some(corner) = points.iter().position(|point| node_of(*point) == node) else {
            continue;
        };
        let at_node = mises(&rule.extrapolate(&state.stress[element])[corner]);
        extrapolated = extrapolated.max(at_node);
        for point in points {
            let value = recovered.mises_nodal[*point as usize];
            smallest = smallest.min(value);
            if is_beside(node_of(*point)) {
                beside = beside.max(value);
            }
        }
    }
    Around {
        jump: extrapolated - peak,
        fall: peak - smallest,
        border: beside - peak,
    }
}
