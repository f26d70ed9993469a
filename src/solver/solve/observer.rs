//! What a running solution tells the outside, and how it is stopped.

use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::solve::checkpoint::restart::Restart;

/// One Newton iteration, all values relative where a tolerance is relative.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Iteration {
    /// Index of the step.
    pub step: usize,
    /// Share of the step that this increment aims at.
    pub time: f64,
    /// Number of the iteration in its increment, from one.
    pub iteration: usize,
    /// Residual force over applied force.
    pub residual: f64,
    /// Work of the residual on the correction over the work of the loads.
    pub energy: f64,
    /// Contact nodes that carry pressure.
    pub active: usize,
    /// Those of them that stick,
    pub sticking: usize,
    /// and those that slip.
    pub slipping: usize,
    /// Contact nodes whose status changed in this iteration.
    pub changed: usize,
    /// Largest violation of a contact condition, as a length over the largest displacement, rigid travel included.
    pub penetration: f64,
    /// Integration points that flow.
    pub flowing: usize,
    /// Krylov directions of the linear solve.
    pub directions: usize,
    /// Was a new factor made for it?
    pub refactored: bool,
    /// Share of the correction that the line search took.
    pub line_search: f64,
}

/// Listens to a solution.
pub trait Observer {
    /// After each Newton iteration.
    fn iteration(&mut self, _: &Iteration) {}
    /// Once, after floating bodies were moved into touch.
    fn moved(&mut self, _: &Scene) {}
    /// After each accepted increment; an error stops the run and is passed on.
    fn increment(&mut self, _: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        Ok(())
    }
    /// After each accepted increment, when all is ready for the next one: what the solution can go on
    /// from, made when asked for. An error stops the run and is passed on.
    fn checkpoint(
        &mut self,
        _: &dyn Fn() -> Restart,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        Ok(())
    }
    /// In words: cut-backs, gap closing, what was found.
    fn message(&mut self, _: &str) {}
    /// Asked between iterations.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Listens to nothing.
pub struct Silent;

impl Observer for Silent {}
