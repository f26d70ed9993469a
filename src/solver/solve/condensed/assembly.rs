//! Elastic stiffness of elements on a sparsity pattern.

use crate::model::material::Moduli;
use crate::model::scene::Scene;
use crate::solver::fem::dofs::DofMap;
use crate::solver::fem::element::Element;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use crate::solver::solve::params::ELEMENTS_PER_BATCH;
use rayon::prelude::*;

/// What the bodies are made from.
pub struct Condensing<'a> {
    pub scene: &'a Scene,
    pub dofs: &'a DofMap,
    pub elastic: &'a [Moduli],
    /// Vertices that must be kept.
    pub needed: &'a [bool],
    /// Elements that are expected to flow, ascending: never condensed.
    pub flow: &'a [u32],
    /// Condense at all?
    pub condense: bool,
}

/// Equations that an element acts on, [`FIXED`](crate::solver::fem::dofs::FIXED) for none.
pub fn equations(plan: &Condensing, element: usize) -> impl Iterator<Item = u32> {
    plan.dofs.of_element(&plan.scene.mesh, element).all()
}

/// Elastic stiffness of elements on a pattern whose equations are numbered by `number`.
pub fn assemble_elastic(
    plan: &Condensing,
    elements: &[u32],
    pattern: &Pattern,
    number: impl Fn(u32) -> u32,
) -> SymmetricMatrix {
    // Element matrices in parallel, a batch at a time; sums in element order.
    let mesh = &plan.scene.mesh;
    let mut matrix = pattern.zeros();
    for batch in elements.chunks(ELEMENTS_PER_BATCH) {
        let blocks: Vec<_> = batch
            .par_iter()
            .map(|e| {
                let moduli = &plan.elastic[mesh.body_of(*e as usize)];
                Box::new(shaped(plan.scene, *e as usize).stiffness(moduli))
            })
            .collect();
        for (element, block) in batch.iter().zip(blocks) {
            let terms = plan.dofs.of_element(mesh, *element as usize);
            let terms = terms.renumbered(&number);
            terms.add(pattern, &mut matrix, &block);
        }
    }
    matrix
}

/// An element with its shape.
pub fn shaped(scene: &Scene, element: usize) -> Element {
    Element::new(scene.controls.element, &scene.mesh.corners(element))
}
