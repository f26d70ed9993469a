//! How often the expensive parts of a solution ran.

use crate::solver::solve::checkpoint::effort::Effort;
use crate::solver::solve::checkpoint::timers::Timers;
use serde::{Deserialize, Serialize};

/// How often the expensive parts ran.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Counters {
    pub iterations: usize,
    pub cut_backs: usize,
    pub effort: Effort,
    pub factorisations: usize,
    pub linear_solves: usize,
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
    pub equations: usize,
    /// Unknowns that are left when the bodies are condensed.
    pub kept_equations: usize,
    pub factor_entries: usize,
    /// Those of them that a factorisation computes; the others belong to condensed bodies.
    pub kept_factor_entries: usize,
    pub contact_rows: usize,
    /// Elements whose yield condition is checked in every iteration.
    pub watched_elements: usize,
    pub timers: Timers,
}
