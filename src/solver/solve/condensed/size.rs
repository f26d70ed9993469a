//! What a model will cost, reckoned before it is made.

use crate::ground::memory::available;
use crate::ground::order::ascending;
use crate::model::scene::{Scene, SolverKind};
use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::solve::condensed::cost::{
    factor_entries, factor_work, seconds_condensed, seconds_divided, seconds_sparse,
    worth_condensing,
};
use crate::solver::solve::params::{FACTOR_MEMORY_SHARE, MODEST_MEMORY};
use std::ops::Range;

/// What a model will take, and how it is to be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Divide it, and not condense its bodies?
    pub divided: bool,
    /// Bytes in all.
    pub memory: f64,
    /// Unknowns that contact or flow acts on.
    pub kept: f64,
}

impl Size {
    /// Of a model that acts on the `needed` vertices and in which the elements `flow` may flow; `large` where it was
    /// found too large before.
    pub fn new(
        scene: &Scene,
        dofs: &DofMap,
        needed: &[bool],
        (flow, large): (&[u32], bool),
    ) -> Self {
        let bodies = bodies(scene, dofs, needed, flow);
        let [whole, parts] = [false, true].map(|divided| memory(&bodies, dofs.len(), divided));
        let divided = match scene.controls.solver {
            SolverKind::Auto => {
                let short = |available| whole > FACTOR_MEMORY_SHARE * available;
                let quicker = |[condensed, sparse]: [f64; 2]| condensed.min(sparse);
                let seconds: f64 = bodies.iter().map(|b| quicker(b.seconds())).sum();
                let of_parts = seconds_divided(dofs.len());
                let is_dear = if whole > MODEST_MEMORY {
                    // Memory counts as much as time.
                    seconds * whole > of_parts * parts
                } else {
                    seconds > of_parts
                };
                large || is_dear || available().is_some_and(short)
            }
            SolverKind::Direct => false,
            SolverKind::Divided => true,
        };
        Self {
            divided,
            memory: if divided { parts } else { whole },
            kept: kept_unknowns(dofs, needed),
        }
    }
}

/// What counts of a body before it is condensed, or left sparse.
struct BodyCount {
    elements: usize,
    /// Unknowns that contact or flow acts on,
    kept: usize,
    /// and those among them of elastic elements: seen from there a condensed body is dense.
    dense: usize,
}

impl BodyCount {
    /// Of an iteration with it condensed and sparse.
    fn seconds(&self) -> [f64; 2] {
        let condensing = factor_work(factor_entries(self.elements));
        [
            seconds_condensed(self.dense, condensing),
            seconds_sparse(self.elements),
        ]
    }
}

fn bodies(scene: &Scene, dofs: &DofMap, needed: &[bool], flow: &[u32]) -> Vec<BodyCount> {
    let vertex_of = dofs.vertices();
    let kept = |elements: &mut dyn Iterator<Item = usize>| {
        let equations = elements.flat_map(|e| dofs.of_element(&scene.mesh, e).all());
        let kept = |e: &u32| *e != FIXED && needed[vertex_of[*e as usize] as usize];
        ascending(equations.filter(kept)).len()
    };
    let elastic = |e: &usize| flow.binary_search(&(*e as u32)).is_err();
    let of = |elements: Range<usize>| BodyCount {
        elements: elements.len(),
        kept: kept(&mut elements.clone()),
        dense: kept(&mut elements.filter(elastic)),
    };
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|body| of(body.elements.clone())).collect()
}

/// Bytes that a model of so many unknowns takes, from runs of 50 to 200 thousand (within a quarter).
fn memory(bodies: &[BodyCount], unknowns: usize, divided: bool) -> f64 {
    let unknowns = unknowns as f64;
    if divided {
        return 6e3 * unknowns;
    }
    let entries: f64 = bodies.iter().map(|b| factor_entries(b.elements)).sum();
    let seconds: Vec<_> = bodies.iter().map(BodyCount::seconds).collect();
    let condensed = (bodies.iter().zip(worth_condensing(&seconds))).filter(|(_, worth)| *worth);
    let kept: f64 = condensed.map(|(b, _)| b.kept as f64).sum();
    2e3 * unknowns + 14.4 * entries + 1.6 * kept.powi(2)
}

/// Unknowns of the needed vertices.
fn kept_unknowns(dofs: &DofMap, needed: &[bool]) -> f64 {
    let starts = dofs.vertex_start.windows(2).zip(needed);
    let kept: u32 = starts.filter(|(_, n)| **n).map(|(s, _)| s[1] - s[0]).sum();
    f64::from(kept)
}
