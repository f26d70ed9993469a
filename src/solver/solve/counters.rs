//! How often the expensive parts of a solution ran.

use super::effort::Effort;
use super::model::Model;
use super::timers::Timers;
use serde::{Deserialize, Serialize};

/// How often the expensive parts ran.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Counters {
    /// Newton iterations.
    pub iterations: usize,
    /// Increments that were tried again with half the size.
    pub cut_backs: usize,
    /// What taking loads off has cost.
    pub effort: Effort,
    /// Factorisations of the matrix that is left when bodies are condensed.
    pub factorisations: usize,
    /// Linear systems that were solved.
    pub linear_solves: usize,
    /// Directions of the iterative solver, in all.
    pub krylov_directions: usize,
    /// Times that residual and laws were evaluated.
    pub evaluations: usize,
    /// Times that the model was prepared: once, and again where something was unforeseen.
    pub preparations: usize,
    /// Elements integrated again for a tangent, because they flow.
    pub element_tangents: usize,
    /// Integration points whose yield condition was checked.
    pub plastic_updates: usize,
    /// Contact nodes whose law was evaluated.
    pub contact_updates: usize,
    /// Those of them with friction.
    pub friction_updates: usize,
    /// Unknowns.
    pub equations: usize,
    /// Unknowns that are left when the bodies are condensed.
    pub kept_equations: usize,
    /// Entries of all factors.
    pub factor_entries: usize,
    /// Those of them that a factorisation computes; the others belong to condensed bodies.
    pub kept_factor_entries: usize,
    /// Contact nodes with a row of their own.
    pub contact_rows: usize,
    /// Elements whose yield condition is checked in every iteration.
    pub watched_elements: usize,
    /// Seconds by phase.
    pub timers: Timers,
}

impl Counters {
    /// Sizes of a model.
    pub fn measure(&mut self, model: &Model) {
        self.equations = model.all.len();
        self.kept_equations = model.dofs.len();
        self.preparations += 1;
        self.kept_factor_entries = model.preconditioner.factor_entries();
        self.factor_entries = model.bodies.factor_entries() + self.kept_factor_entries;
        self.watched_elements = model.yielding.len();
        self.contact_rows = model.rows.len();
    }
}
