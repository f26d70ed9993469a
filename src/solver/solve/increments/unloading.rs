//! What stays when a load has been taken off, and a load that could not be taken off to the end.

use crate::ground::geometry::Vec3;
use crate::model::scene::UNLOADED_SHARE;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::spring_back::spring_back_of;

impl Run<'_, '_> {
    /// What stays once all loads are off, where the steps that take them off are done. Dents can be told without
    /// it, so what goes wrong here is told and no error.
    pub(super) fn stays(&mut self) -> Option<Vec<Vec3>> {
        let steps = self.model.scene.steps.len();
        let unloaded = self.model.scene.before_unloading().is_some() && self.states.len() == steps;
        let state = self.states.last().filter(|_| unloaded)?;
        // The factor of the last tangent would be memory beside that of the bodies alone.
        self.solver.forget();
        let stays = || spring_back_of(&self.model, state);
        let stays = self.counters.timers.time(Phase::Recover, stays);
        let told = |error| (self.observer).message(&format!("dents keep an elastic part: {error}"));
        stays.map_err(told).ok()
    }

    /// What went wrong, if only the taking off of the load did. What is left of the answer stands; where next to
    /// no load was left, it counts as taken off.
    pub(super) fn stuck(&mut self, error: &SolveError) -> Option<String> {
        let scene = self.model.scene;
        let full = scene.before_certain_unloading()?;
        let unloads = self.states.len() > full && self.last.step > full;
        if !unloads || !error.is_of_balance() {
            return None;
        }
        let (step, time) = (self.last.step, self.last.time);
        let mut shares = scene.acting_names().into_iter().map(|name| {
            let at = |step, time| scene.factor(name, step, time).abs();
            (at(step, time), at(full, 1.0))
        });
        if step + 1 == scene.steps.len() && shares.all(|(now, then)| now <= UNLOADED_SHARE * then) {
            self.states.push(self.last.clone());
        }
        Some(format!(
            "the load was taken off to {:.3} % of step `{}` only; what is said at full load stands ({error})",
            100.0 * time,
            scene.steps[step].name,
        ))
    }
}
