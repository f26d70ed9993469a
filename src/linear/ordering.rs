//! Fill-reducing order: METIS nested dissection on the vertex graph, then a postorder.
//!
//! faer's own minimum-degree order costs three to four times the work on hexahedral meshes, and
//! the crate `metis` has no wrapper for node dissection, so `METIS_NodeND` is called directly.

use super::sparse::Pattern;
use std::sync::Mutex;

/// METIS draws on the C library's random state: one call at a time keeps it reproducible.
static METIS: Mutex<()> = Mutex::new(());

/// New order of the equations: `order[k]` is the equation that is eliminated as number k.
pub fn nested_dissection(pattern: &Pattern) -> Vec<u32> {
    let vertices = dissect(pattern);
    let mut order = Vec::with_capacity(pattern.len());
    for vertex in vertices {
        let vertex = vertex as usize;
        order.extend(pattern.vertex_start[vertex]..pattern.vertex_start[vertex + 1]);
    }
    order
}

/// Elimination order of the vertices.
fn dissect(pattern: &Pattern) -> Vec<u32> {
    let count = pattern.vertex_start.len().saturating_sub(1);
    let mut start: Vec<i32> = pattern.adjacency_start.iter().map(|v| *v as i32).collect();
    let mut adjacency: Vec<i32> = pattern.adjacency.iter().map(|v| *v as i32).collect();
    let mut weights: Vec<i32> = pattern
        .vertex_start
        .windows(2)
        .map(|w| (w[1] - w[0]) as i32)
        .collect();
    let mut vertices = count as i32;
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
    let order: Vec<u32> = if status == metis_sys::rstatus_et_METIS_OK {
        perm.iter().map(|v| *v as u32).collect()
    } else {
        // The natural order is correct, only slower.
        (0..count as u32).collect()
    };
    postorder(pattern, &order)
}

/// Reorders `order` along a postorder of its elimination tree: the same fill, but columns of a
/// supernode stand together.
fn postorder(pattern: &Pattern, order: &[u32]) -> Vec<u32> {
    let parent = elimination_tree(pattern, order);
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
fn elimination_tree(pattern: &Pattern, order: &[u32]) -> Vec<u32> {
    let count = order.len();
    let mut position = vec![0u32; count];
    for (k, vertex) in order.iter().enumerate() {
        position[*vertex as usize] = k as u32;
    }
    let (mut parent, mut ancestor) = (vec![u32::MAX; count], vec![u32::MAX; count]);
    for k in 0..count as u32 {
        let vertex = order[k as usize] as usize;
        let range =
            pattern.adjacency_start[vertex] as usize..pattern.adjacency_start[vertex + 1] as usize;
        for &other in &pattern.adjacency[range] {
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
