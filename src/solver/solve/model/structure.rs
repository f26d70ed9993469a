//! Which unknowns are kept, and how they hang together.

use crate::ground::order::ascending;
use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use crate::solver::fem::dofs::DofMap;
use crate::solver::linear::cholesky::Symbolic;
use crate::solver::linear::sparse::Pattern;
use crate::solver::solve::condensed::assembly::Condensing;
use crate::solver::solve::condensed::cost::{seconds_direct, seconds_divided};
use crate::solver::solve::condensed::static_condensation::CondensedBodies;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::rows::contact_row::ContactRow;

/// Which unknowns are kept, and how they hang together.
pub struct Structure {
    pub bodies: CondensedBodies,
    pub dofs: DofMap,
    pub pattern: Pattern,
    /// Of one factor; `None` of a divided model.
    pub symbolic: Option<Symbolic>,
}

impl Structure {
    pub fn new(plan: &Condensing, rows: &[ContactRow]) -> Result<Self, SolveError> {
        let bodies = CondensedBodies::new(plan)?;
        let dofs = bodies.kept_dofs(plan.dofs);
        let pattern = pattern(&plan.scene.mesh, &bodies, &dofs, rows);
        let symbolic = if plan.condense {
            Some(Symbolic::new(&pattern, &bodies.blocks)?)
        } else {
            None
        };
        Ok(Self {
            bodies,
            dofs,
            pattern,
            symbolic,
        })
    }

    /// Would iterations of the divided model, of so many unknowns in all, cost less?
    pub fn is_dear(&self, unknowns: usize) -> bool {
        self.symbolic.as_ref().is_some_and(|symbolic| {
            let entries = symbolic.factor_entries() as f64;
            // What has been condensed is a loss either way.
            seconds_direct(symbolic.work(), entries, 0.0) > seconds_divided(unknowns)
        })
    }
}

/// Vertices that contact or expected flow acts on.
pub fn needed(scene: &Scene, dofs: &DofMap, rows: &[ContactRow], flow: &[u32]) -> Vec<bool> {
    let vertex_of = dofs.vertices();
    let mut needed = vec![false; dofs.vertex_start.len() - 1];
    let flowing = flow.iter().flat_map(|e| scene.mesh.hexes[*e as usize]);
    let touching = rows.iter().flat_map(|r| r.row.terms.iter().map(|t| t.0));
    for node in flowing.chain(touching) {
        for (equation, ..) in dofs.terms(node) {
            needed[vertex_of[equation as usize] as usize] = true;
        }
    }
    needed
}

fn pattern(mesh: &Mesh, bodies: &CondensedBodies, dofs: &DofMap, rows: &[ContactRow]) -> Pattern {
    let vertex_of = dofs.vertices();
    let vertices = |nodes: &mut dyn Iterator<Item = u32>| {
        let terms = nodes.flat_map(|n| dofs.terms(n));
        ascending(terms.map(|(e, ..)| vertex_of[e as usize]))
    };
    let elements = bodies
        .sparse_elements
        .iter()
        .map(|e| vertices(&mut mesh.hexes[*e as usize].iter().copied()));
    let contacts = rows
        .iter()
        .map(|r| vertices(&mut r.row.terms.iter().map(|t| t.0)));
    let cliques: Vec<Vec<u32>> = elements.chain(contacts).chain(bodies.cliques()).collect();
    Pattern::new(dofs.vertex_start.clone(), cliques.iter().map(Vec::as_slice))
}
