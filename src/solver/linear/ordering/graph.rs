//! The graph that is ordered: nested dissection by METIS, and the postorder of its elimination tree.

use crate::solver::linear::sparse::Pattern;
use std::sync::Mutex;

/// METIS draws on the C library's random state: one call at a time keeps it reproducible.
pub(in crate::solver::linear) static METIS: Mutex<()> = Mutex::new(());

fn vertices(pattern: &Pattern) -> usize {
    pattern.vertex_start.len().saturating_sub(1)
}

/// The graph that is dissected: some of a pattern's vertices.
pub(super) struct Graph {
    /// Their numbers in the pattern.
    pub vertices: Vec<u32>,
    start: Vec<i32>,
    adjacency: Vec<i32>,
    /// Equations of each vertex.
    weights: Vec<i32>,
}

impl Graph {
    /// The graph of the marked vertices of a pattern.
    pub fn of(pattern: &Pattern, marked: impl Fn(usize) -> bool) -> Self {
        let mut local = vec![-1i32; vertices(pattern)];
        let mut graph = Self {
            vertices: Vec::new(),
            start: vec![0],
            adjacency: Vec::new(),
            weights: Vec::new(),
        };
        for (vertex, number) in local.iter_mut().enumerate().filter(|(v, _)| marked(*v)) {
            *number = graph.vertices.len() as i32;
            graph.vertices.push(vertex as u32);
        }
        for &vertex in &graph.vertices {
            let vertex = vertex as usize;
            let neighbours = pattern.adjacency_start[vertex]..pattern.adjacency_start[vertex + 1];
            let neighbours = &pattern.adjacency[neighbours.start as usize..neighbours.end as usize];
            let inside = neighbours.iter().map(|v| local[*v as usize]);
            graph.adjacency.extend(inside.filter(|v| *v >= 0));
            graph.start.push(graph.adjacency.len() as i32);
            let equations = pattern.vertex_start[vertex + 1] - pattern.vertex_start[vertex];
            graph.weights.push(equations as i32);
        }
        graph
    }

    /// Of some vertices, ascending; costs nothing for the others.
    pub fn of_part(pattern: &Pattern, part: &[u32]) -> Self {
        let mut graph = Self {
            vertices: part.to_vec(),
            start: vec![0],
            adjacency: Vec::new(),
            weights: Vec::new(),
        };
        for &vertex in part {
            let neighbours = pattern.neighbours(vertex as usize).iter();
            let inside = neighbours.filter_map(|v| part.binary_search(v).ok());
            graph.adjacency.extend(inside.map(|v| v as i32));
            graph.start.push(graph.adjacency.len() as i32);
            let starts = &pattern.vertex_start[vertex as usize..];
            graph.weights.push((starts[1] - starts[0]) as i32);
        }
        graph
    }

    fn neighbours(&self, vertex: usize) -> &[i32] {
        &self.adjacency[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }

    /// Elimination order of the vertices.
    pub fn dissect(&self) -> Vec<u32> {
        let count = self.vertices.len();
        if count == 0 {
            return Vec::new();
        }
        let mut vertices = count as i32;
        let (mut start, mut adjacency) = (self.start.clone(), self.adjacency.clone());
        let mut weights = self.weights.clone();
        let (mut perm, mut inverse) = (vec![0i32; count], vec![0i32; count]);
        let status = {
            let _one_at_a_time = METIS
                .lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner());
            // SAFETY: all arrays have the lengths METIS documents for `vertices` vertices, and the
            // graph is symmetric without loops by construction; the options may be null.
            unsafe {
                metis_sys::METIS_NodeND(
                    &mut vertices,
                    start.as_mut_ptr(),
                    adjacency.as_mut_ptr(),
                    weights.as_mut_ptr(),
                    std::ptr::null_mut(),
                    perm.as_mut_ptr(),
                    inverse.as_mut_ptr(),
                )
            }
        };
        if status == metis_sys::rstatus_et_METIS_OK {
            perm.iter().map(|v| *v as u32).collect()
        } else {
            // The natural order is correct, only slower.
            (0..count as u32).collect()
        }
    }

    /// Reorders `order` along a postorder of its elimination tree: the same fill, but columns of a
    /// supernode stand together.
    pub fn postorder(&self, order: &[u32]) -> Vec<u32> {
        let parent = self.elimination_tree(order);
        let count = order.len();
        let (mut first_child, mut sibling) = (vec![u32::MAX; count + 1], vec![u32::MAX; count]);
        // Backwards, so that children come out in ascending order; roots hang on `count`.
        for k in (0..count).rev() {
            let parent = (parent[k] as usize).min(count);
            sibling[k] = first_child[parent];
            first_child[parent] = k as u32;
        }
        let mut out = Vec::with_capacity(count);
        let mut stack = vec![count as u32];
        while let Some(&top) = stack.last() {
            let child = first_child[top as usize];
            if child == u32::MAX {
                stack.pop();
                if (top as usize) < count {
                    out.push(order[top as usize]);
                }
            } else {
                first_child[top as usize] = sibling[child as usize];
                stack.push(child);
            }
        }
        out
    }

    /// Parent of each position in the elimination tree of the reordered graph, `u32::MAX` for roots
    /// (Liu 1990, with path compression).
    fn elimination_tree(&self, order: &[u32]) -> Vec<u32> {
        let count = order.len();
        let mut position = vec![0u32; count];
        for (k, vertex) in order.iter().enumerate() {
            position[*vertex as usize] = k as u32;
        }
        let (mut parent, mut ancestor) = (vec![u32::MAX; count], vec![u32::MAX; count]);
        for k in 0..count as u32 {
            for &other in self.neighbours(order[k as usize] as usize) {
                let mut i = position[other as usize];
                while i < k {
                    let next = ancestor[i as usize];
                    ancestor[i as usize] = k;
                    if next == u32::MAX {
                        parent[i as usize] = k;
                        break;
                    }
                    i = next;
                }
            }
        }
        parent
    }
}
