//! What a model will cost, reckoned before it is made.

use crate::ground::memory::available;
use crate::model::scene::{Scene, SolverKind};
use crate::solver::fem::dofs::{DofMap, FIXED};
use crate::solver::solve::condensed::cost::{condensation_work, seconds_direct, seconds_divided};
use crate::solver::solve::params::FACTOR_MEMORY_SHARE;

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
        let divided = match scene.controls.solver {
            SolverKind::Auto => {
                let short = |available| {
                    memory_of(scene, dofs, needed, false) > FACTOR_MEMORY_SHARE * available
                };
                large || is_large(scene, dofs, needed, flow) || available().is_some_and(short)
            }
            SolverKind::Direct => false,
            SolverKind::Divided => true,
        };
        Self {
            divided,
            memory: memory_of(scene, dofs, needed, divided),
            kept: kept_unknowns(dofs, needed),
        }
    }
}

/// Is it certainly better to divide the model than to condense its bodies? Seen from the unknowns that are needed of
/// its elastic elements each body is dense: more than that its factor cannot be spared.
fn is_large(scene: &Scene, dofs: &DofMap, needed: &[bool], flow: &[u32]) -> bool {
    let vertex_of = dofs.vertices();
    let bodies = scene.mesh.bodies.iter().map(|body| {
        let elastic = |e: &usize| flow.binary_search(&(*e as u32)).is_err();
        let elements = body.elements.clone().filter(elastic);
        let equations = elements.flat_map(|e| dofs.of_element(&scene.mesh, e).all());
        let mut dense: Vec<u32> = equations
            .filter(|e| *e != FIXED && needed[vertex_of[*e as usize] as usize])
            .collect();
        dense.sort_unstable();
        dense.dedup();
        let condensing = condensation_work(factor_entries(body.elements.len()));
        ((dense.len() as f64).powi(3) / 6.0, condensing)
    });
    let (dense, condensing) = bodies.fold((0.0, 0.0), |sum, b| (sum.0 + b.0, sum.1 + b.1));
    seconds_direct(dense, 0.0, condensing) > seconds_divided(dofs.len())
}

/// Bytes that a model takes, from runs of 50 to 200 thousand unknowns (within a quarter).
fn memory_of(scene: &Scene, dofs: &DofMap, needed: &[bool], divided: bool) -> f64 {
    let unknowns = dofs.len() as f64;
    if divided {
        return 6e3 * unknowns;
    }
    2e3 * unknowns + 14.4 * body_factor_entries(scene) + 1.6 * kept_unknowns(dofs, needed).powi(2)
}

/// Unknowns of the needed vertices.
fn kept_unknowns(dofs: &DofMap, needed: &[bool]) -> f64 {
    let starts = dofs.vertex_start.windows(2).zip(needed);
    let kept: u32 = starts.filter(|(_, n)| **n).map(|(s, _)| s[1] - s[0]).sum();
    f64::from(kept)
}

/// Entries of the factors of all bodies.
fn body_factor_entries(scene: &Scene) -> f64 {
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|b| factor_entries(b.elements.len())).sum()
}

/// About how many entries the factor of a compact body has, ordered by METIS (73 million for a cube
/// of 30 elements a side, 241 million for one of 40).
fn factor_entries(elements: usize) -> f64 {
    73e6 * (elements as f64 / 27e3).powf(1.4)
}
