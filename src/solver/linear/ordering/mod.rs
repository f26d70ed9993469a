//! Fill-reducing order: METIS nested dissection on the vertex graph, then a postorder.
//!
//! faer's own minimum-degree order costs three to four times the work on hexahedral meshes, and
//! the crate `metis` has no wrapper for node dissection, so `METIS_NodeND` is called directly.

mod graph;

use super::sparse::Pattern;
use graph::Graph;
pub(super) use graph::METIS;
use std::ops::Range;

/// Vertices that are eliminated together, before those of the blocks after them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Block {
    /// Coupled to few others each: dissected.
    Sparse(Range<u32>),
    /// Coupled to each other in full: as they stand.
    Dense(Range<u32>),
}

/// New order of the equations: `order[k]` is the equation that is eliminated as number k.
pub fn blockwise(pattern: &Pattern, blocks: &[Block]) -> Vec<u32> {
    let mut order = Vec::with_capacity(pattern.len());
    for block in blocks {
        let vertices = match block {
            Block::Dense(range) => range.clone().collect(),
            Block::Sparse(range) => dissected(pattern, |v| range.contains(&(v as u32))),
        };
        push(pattern, vertices, &mut order);
    }
    order
}

/// Order with the marked vertices last and ascending, and how many equations come before them.
pub(super) fn with_last(pattern: &Pattern, last: &[bool]) -> (Vec<u32>, usize) {
    let mut order = Vec::with_capacity(pattern.len());
    push(pattern, dissected(pattern, |v| !last[v]), &mut order);
    let before = order.len();
    let last = (0..last.len() as u32).filter(|v| last[*v as usize]);
    push(pattern, last.collect(), &mut order);
    (order, before)
}

/// Order of the equations of some vertices, ascending, among themselves; `starts` are the first
/// equations of the vertices in that numbering.
pub(super) fn of_part(pattern: &Pattern, part: &[u32], starts: &[u32]) -> Vec<u32> {
    let graph = Graph::of_part(pattern, part);
    let mut order = Vec::new();
    for vertex in graph.postorder(&graph.dissect()) {
        order.extend(starts[vertex as usize]..starts[vertex as usize + 1]);
    }
    order
}

/// The equations of vertices.
fn push(pattern: &Pattern, vertices: Vec<u32>, order: &mut Vec<u32>) {
    for vertex in vertices {
        let vertex = vertex as usize;
        order.extend(pattern.vertex_start[vertex]..pattern.vertex_start[vertex + 1]);
    }
}

/// Vertices with a mark, in the order of nested dissection.
fn dissected(pattern: &Pattern, marked: impl Fn(usize) -> bool) -> Vec<u32> {
    let graph = Graph::of(pattern, marked);
    let local = graph.postorder(&graph.dissect());
    local
        .into_iter()
        .map(|v| graph.vertices[v as usize])
        .collect()
}
