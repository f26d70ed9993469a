//! Groups of bodies that share vertices, each condensed by itself.

use crate::ground::order::ascending;
use crate::solver::fem::dofs::FIXED;
use crate::solver::linear::sparse::Pattern;
use crate::solver::solve::condensed::assembly::{Condensing, equations};

/// Bodies that share vertices, without the elements that are expected to flow. A vertex is a node or a rigid plane
/// with its equations.
pub struct Group {
    pub elements: Vec<u32>,
    /// Vertices of the elements, ascending.
    pub vertices: Vec<u32>,
    /// Vertices of elements that are expected to flow and of no other, ascending.
    pub zone: Vec<u32>,
}

/// Groups of bodies that share vertices.
pub fn groups(plan: &Condensing, vertex_of: &[u32]) -> Vec<Group> {
    let mesh = &plan.scene.mesh;
    let vertices = plan.dofs.vertex_start.len() - 1;
    let mut owner = vec![None::<usize>; vertices];
    // The group of a body is the lowest body that it hangs together with.
    let mut group: Vec<usize> = (0..mesh.bodies.len()).collect();
    for (index, body) in mesh.bodies.iter().enumerate() {
        for element in body.elements.clone() {
            for equation in equations(plan, element) {
                if equation == FIXED {
                    continue;
                }
                let slot = &mut owner[vertex_of[equation as usize] as usize];
                let (a, b) = (group[*slot.get_or_insert(index)], group[index]);
                if a != b {
                    let (low, high) = (a.min(b), a.max(b));
                    group
                        .iter_mut()
                        .filter(|g| **g == high)
                        .for_each(|g| *g = low);
                }
            }
        }
    }
    let touched = |elements: &[u32]| {
        let mut touched = vec![false; vertices];
        for element in elements {
            let free = equations(plan, *element as usize);
            free.filter(|e| *e != FIXED)
                .for_each(|e| touched[vertex_of[e as usize] as usize] = true);
        }
        touched
    };
    let mut made: Vec<Group> = Vec::new();
    for index in 0..mesh.bodies.len() {
        let members = (0..mesh.bodies.len()).filter(|b| group[*b] == index);
        let (flow, elements): (Vec<u32>, Vec<u32>) = members
            .flat_map(|b| mesh.bodies[b].elements.clone())
            .map(|e| e as u32)
            .partition(|e| plan.flow.binary_search(e).is_ok());
        let (inside, zone) = (touched(&elements), touched(&flow));
        let of = |mark: &dyn Fn(usize) -> bool| -> Vec<u32> {
            (0..vertices)
                .filter(|v| mark(*v))
                .map(|v| v as u32)
                .collect()
        };
        made.push(Group {
            vertices: of(&|v| inside[v]),
            zone: of(&|v| zone[v] && !inside[v]),
            elements,
        });
    }
    made.retain(|group| !group.vertices.is_empty() || !group.zone.is_empty());
    made
}

/// Equations of a group, ascending, and the position of each equation among them.
pub fn numbering(plan: &Condensing, group: &Group) -> (Vec<u32>, Vec<u32>) {
    let starts = &plan.dofs.vertex_start;
    let equations: Vec<u32> = group
        .vertices
        .iter()
        .flat_map(|v| starts[*v as usize]..starts[*v as usize + 1])
        .collect();
    let mut local_of = vec![FIXED; plan.dofs.len()];
    for (local, equation) in equations.iter().enumerate() {
        local_of[*equation as usize] = local as u32;
    }
    (equations, local_of)
}

pub fn local_pattern(plan: &Condensing, vertex_of: &[u32], group: &Group) -> Pattern {
    let mut local = vec![0u32; plan.needed.len()];
    let mut starts = vec![0];
    for (number, vertex) in group.vertices.iter().enumerate() {
        let vertex = *vertex as usize;
        local[vertex] = number as u32;
        let equations = plan.dofs.vertex_start[vertex + 1] - plan.dofs.vertex_start[vertex];
        starts.push(starts[number] + equations);
    }
    let cliques: Vec<Vec<u32>> = group
        .elements
        .iter()
        .map(|e| {
            let free = equations(plan, *e as usize).filter(|e| *e != FIXED);
            ascending(free.map(|e| local[vertex_of[e as usize] as usize]))
        })
        .collect();
    Pattern::new(starts, cliques.iter().map(Vec::as_slice))
}
