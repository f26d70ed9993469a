//! What an accepted increment leaves.

use crate::ground::geometry::Vec3;
use crate::model::state::Energy;
use crate::model::state::turn::{TOO_FAR, largest_turn};
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::flowing::work_on;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::increments::turning_flow::Balanced;
use crate::solver::solve::recovery::state::recovered_state;
use crate::solver::solve::working_set::unforeseen::Unforeseen;
use std::sync::Arc;

impl Run<'_, '_> {
    /// Goes on to an increment; is it the `last` of its step? Returns what it did not foresee.
    pub(super) fn accept(
        &mut self,
        balanced: Balanced,
        last: bool,
    ) -> Result<Unforeseen, SolveError> {
        let Balanced {
            trial,
            u,
            ref evaluation,
            ref lacking,
            unforeseen,
        } = balanced;
        let mut accepted = trial;
        self.history.advance(&mut accepted, evaluation);
        self.point = accepted;
        let mut timers = self.counters.timers;
        let state = timers.time(Phase::Recover, || {
            let (model, point) = (&self.model, &self.point);
            let with = (evaluation, self.sights.as_slice());
            let mut state = recovered_state(model, &self.history, (point, u), with);
            let before = if self.last.displacement.is_empty() {
                Some(Energy::default())
            } else {
                self.last.energy
            };
            let energy = before.and_then(|energy| energy.after(model, &self.last, &state));
            state.energy = energy.map(|energy| Energy {
                plastic: energy.plastic + work_on(lacking, model.scene, [&self.last, &state]),
                ..energy
            });
            state
        });
        self.counters.timers = timers;
        self.observer
            .increment(&state)
            .map_err(SolveError::Observer)?;
        if last {
            let plastic = self.history.all_plastic(&self.model);
            self.finished.push(Arc::new(Kept::new(&state, plastic)));
            self.states.push(state.clone());
        }
        self.last = state;
        Ok(unforeseen)
    }

    /// Contact that has gone elsewhere: small rotations do not describe it. The part of a body that mirror planes leave
    /// also turns where the whole only bends.
    pub(super) fn turns_far(&self, step: usize, displacement: &[Vec3]) -> Option<SolveError> {
        let scene = self.model.scene;
        if scene.contacts.is_empty() || !scene.mirrors.is_empty() {
            return None;
        }
        let (body, angle) = largest_turn(&scene.mesh, displacement)?;
        (angle > TOO_FAR).then(|| SolveError::TurnsFar {
            step: scene.steps[step].name.clone(),
            percent: 100.0 * self.stands(step),
            body: body.to_owned(),
            angle,
        })
    }
}
