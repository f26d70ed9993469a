//! What a job has found.

use super::limits;
use crate::answer::results::ending::ending;
use crate::case::Case;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::Summary;
use crate::solver::solve::Solution;

/// A finished job.
#[derive(Debug)]
pub struct Outcome {
    /// The scene as solved, its bodies in touch.
    pub scene: Scene,
    /// States at the ends of all steps, and what they cost.
    pub solution: Solution,
    /// Of the end of the last step, or, where the last steps unload, of the step before them.
    pub summary: Summary,
    /// Was the observer's wish to stop met, before or while the elastic peaks were sought?
    pub interrupted: bool,
}

impl Outcome {
    /// Limits that the answer misses, in words.
    pub fn missed_limits(&self, case: &Case) -> Vec<String> {
        limits::missed(case, &self.summary.answer)
    }

    /// The state that the figures are of.
    pub fn state(&self) -> &State {
        reported(&self.scene, &self.solution)
    }
}

/// The state that the figures are of.
pub(super) fn reported<'s>(scene: &Scene, solution: &'s Solution) -> &'s State {
    ending(scene, &solution.states, &solution.last).reported
}

/// The unloaded state, where the last steps unload.
pub(super) fn unloaded<'s>(scene: &Scene, solution: &'s Solution) -> Option<&'s State> {
    ending(scene, &solution.states, &solution.last).unloaded
}
