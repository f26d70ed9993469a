//! How often the expensive parts of a solution ran.

use crate::solver::solve::checkpoint::effort::Effort;
use crate::solver::solve::checkpoint::timers::Timers;
use serde::{Deserialize, Serialize};

/// How often the expensive parts ran.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Counters {
    /// Newton iterations.
    pub iterations: usize,
    /// Increments that were made smaller after they had failed.
    pub cut_backs: usize,
    /// Where the iterations went.
    pub effort: Effort,
    /// Factors that were made.
    pub factorisations: usize,
    /// Tangent systems that were solved,
    pub linear_solves: usize,
    /// and directions of the Krylov method in all of them.
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
    /// Contact nodes that may close.
    pub contact_rows: usize,
    /// Elements whose yield condition is checked in every iteration.
    pub watched_elements: usize,
    /// Seconds by phase.
    pub timers: Timers,
}
