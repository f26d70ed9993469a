//! Subdomains: METIS partitions the vertex graph across weak couplings.

use super::place::Place;
use crate::ground::order::ascending;
use crate::solver::linear::ordering::METIS;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use rayon::prelude::*;

/// How the vertices are divided.
pub(super) struct Division {
    /// Vertices of each subdomain with its overlap, ascending.
    pub subdomains: Vec<Vec<u32>>,
    /// The subdomain that owns each vertex.
    pub owner: Vec<u32>,
    /// Vertices of each body within each subdomain that owns some of it, ascending. Bodies in
    /// contact may slide or part, so they move by themselves in the coarse system.
    pub pieces: Vec<Vec<u32>>,
}

/// METIS weight of the strongest coupling; METIS takes whole numbers.
const STRONGEST: f64 = 1000.0;

/// What a coupling by contact counts for, over the strongest coupling: it has no entry in the guide, and is stiff
/// while it is closed.
const CONTACT_COUPLING: f64 = 0.3;

/// The graph of a pattern with the numbers that guide its division.
struct Graph<'a> {
    pattern: &'a Pattern,
    guide: &'a SymmetricMatrix,
    places: &'a [Place],
}

/// Divides into subdomains of about `size` vertices.
pub(super) fn divide(
    pattern: &Pattern,
    guide: &SymmetricMatrix,
    places: &[Place],
    size: usize,
) -> Division {
    let graph = Graph {
        pattern,
        guide,
        places,
    };
    let cores = graph.split(size);
    let mut owner = vec![0; graph.len()];
    for (index, core) in cores.iter().enumerate() {
        core.iter().for_each(|v| owner[*v as usize] = index as u32);
    }
    let subdomains: Vec<Vec<u32>> = cores.par_iter().map(|core| graph.extended(core)).collect();
    let body = graph.bodies();
    let pieces = (cores.par_iter().zip(&subdomains))
        .flat_map_iter(|(core, all)| pieces(&body, core, all))
        .collect();
    Division {
        subdomains,
        owner,
        pieces,
    }
}

/// The vertices `all` of each body of `core`.
fn pieces(body: &[u32], core: &[u32], all: &[u32]) -> Vec<Vec<u32>> {
    let inside = ascending(core.iter().map(|v| body[*v as usize]));
    let of = |b: u32| all.iter().copied().filter(move |v| body[*v as usize] == b);
    inside.into_iter().map(|b| of(b).collect()).collect()
}

impl Graph<'_> {
    fn len(&self) -> usize {
        self.pattern.vertex_start.len() - 1
    }

    /// Does the vertex stand for a motion that many nodes share?
    fn is_shared(&self, v: u32) -> bool {
        self.places[self.pattern.vertex_start[v as usize] as usize].is_none()
    }

    /// Neighbours that are nodes.
    fn near(&self, v: u32) -> impl Iterator<Item = u32> {
        let all = self.pattern.neighbours(v as usize).iter().copied();
        all.filter(|w| !self.is_shared(*w))
    }

    /// Disjoint subdomains; a shared motion stands alone.
    fn split(&self, size: usize) -> Vec<Vec<u32>> {
        let (nodes, shared): (Vec<u32>, Vec<u32>) =
            (0..self.len() as u32).partition(|v| !self.is_shared(*v));
        let mut local = vec![0i32; self.len()];
        for (number, v) in nodes.iter().enumerate() {
            local[*v as usize] = number as i32;
        }
        let edges: Vec<Vec<(i32, i32)>> = (nodes.par_iter())
            .map(|v| {
                let edges = self.near(*v);
                edges
                    .map(|w| (local[w as usize], self.weight(*v, w)))
                    .collect()
            })
            .collect();
        let count = nodes.len().div_ceil(size).max(1);
        let mut cores = vec![Vec::new(); count];
        for (v, part) in nodes.iter().zip(metis(&edges, count)) {
            cores[part as usize].push(*v);
        }
        cores.retain(|core| !core.is_empty());
        cores.extend(shared.into_iter().map(|v| vec![v]));
        cores
    }

    fn extended(&self, core: &[u32]) -> Vec<u32> {
        let inner = core.iter().filter(|v| !self.is_shared(**v));
        let near = inner.flat_map(|v| self.near(*v));
        ascending(core.iter().copied().chain(near))
    }

    /// Which body each vertex belongs to: what hangs together in the guide.
    fn bodies(&self) -> Vec<u32> {
        const NONE: u32 = u32::MAX;
        let mut body = vec![NONE; self.len()];
        for first in 0..self.len() as u32 {
            if body[first as usize] != NONE {
                continue;
            }
            body[first as usize] = first;
            let mut stack = vec![first];
            stack.retain(|v| !self.is_shared(*v));
            while let Some(v) = stack.pop() {
                for w in self.near(v) {
                    if body[w as usize] == NONE && self.coupling(v, w) != 0.0 {
                        body[w as usize] = first;
                        stack.push(w);
                    }
                }
            }
        }
        body
    }

    fn weight(&self, v: u32, w: u32) -> i32 {
        let coupling = self.coupling(v, w);
        let share = match coupling == 0.0 {
            true => CONTACT_COUPLING,
            false => coupling / (self.stiffness(v) * self.stiffness(w)).sqrt(),
        };
        (STRONGEST * share).clamp(1.0, STRONGEST) as i32
    }

    /// Trace of a vertex's own block.
    fn stiffness(&self, v: u32) -> f64 {
        let starts = &self.pattern.vertex_start;
        let own = starts[v as usize]..starts[v as usize + 1];
        let diagonal = own.map(|e| self.guide.values[self.pattern.columns[e as usize] as usize]);
        diagonal.sum()
    }

    /// Norm of the block between two vertices.
    fn coupling(&self, v: u32, w: u32) -> f64 {
        let block = self.pattern.block(self.guide, v.min(w), v.max(w));
        let squares = block.map(|line| line.iter().map(|v| v * v).sum::<f64>());
        squares.iter().sum::<f64>().sqrt()
    }
}

/// The part of each vertex, from its weighted edges.
fn metis(edges: &[Vec<(i32, i32)>], parts: usize) -> Vec<i32> {
    let mut part = vec![0i32; edges.len()];
    if parts == 1 {
        return part;
    }
    let (mut start, mut adjacency, mut weights) = (vec![0i32], Vec::new(), Vec::new());
    for list in edges {
        adjacency.extend(list.iter().map(|e| e.0));
        weights.extend(list.iter().map(|e| e.1));
        start.push(adjacency.len() as i32);
    }
    let mut vertices = edges.len() as i32;
    let (mut one, mut count, mut cut) = (1i32, parts as i32, 0i32);
    let _one_at_a_time = METIS.lock().unwrap_or_else(|p| p.into_inner());
    // SAFETY: the arrays have the lengths METIS documents for this graph, which is symmetric
    // without loops by construction; arguments that are null may be.
    let status = unsafe {
        metis_sys::METIS_PartGraphKway(
            &mut vertices,
            &mut one,
            start.as_mut_ptr(),
            adjacency.as_mut_ptr(),
            std::ptr::null_mut(),
            std::ptr::null_mut(),
            weights.as_mut_ptr(),
            &mut count,
            std::ptr::null_mut(),
            std::ptr::null_mut(),
            std::ptr::null_mut(),
            &mut cut,
            part.as_mut_ptr(),
        )
    };
    if status != metis_sys::rstatus_et_METIS_OK {
        // Runs of neighbouring numbers: correct, only slower.
        let size = edges.len().div_ceil(parts);
        part = (0..edges.len()).map(|v| (v / size) as i32).collect();
    }
    part
}
