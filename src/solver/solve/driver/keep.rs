//! What an accepted increment leaves, and going on from there.

use super::Run;
use crate::model::state::turn::{TOO_FAR, largest_turn};
use crate::model::state::{Energy, State};
use crate::solver::solve::error::SolveError;
use crate::solver::solve::evaluate::Evaluation;
use crate::solver::solve::newton::Point;
use crate::solver::solve::restart::{Kept, Restart};
use crate::solver::solve::state::recovered_state;
use crate::solver::solve::timers::Phase;

impl Run<'_, '_> {
    /// Takes up what a run before has left.
    pub(super) fn go_on_from(&mut self, restart: &Restart) {
        let timers = self.counters.timers;
        (self.point, self.history) = restart.place(&self.model);
        self.counters = restart.counters;
        self.counters.measure(&self.model);
        self.counters.timers.add(&timers);
        self.size = restart.size;
        self.finished.clone_from(&restart.finished);
        let model = &self.model;
        self.states = (restart.finished.iter().map(|kept| kept.restore(model))).collect();
        self.last = restart.last.restore(model);
        self.beside = restart.beside.clone();
        self.companion = (restart.companion.as_ref()).and_then(|kept| kept.place(model));
        let (step, time) = restart.after();
        self.observer.message(&format!(
            "goes on after {:.3} % of step `{}`",
            100.0 * time,
            model.scene.steps[step].name
        ));
    }

    /// Refuses contact that has gone elsewhere: small rotations do not describe it. The part of a body that mirror
    /// planes leave also turns where the whole only bends.
    fn refuse_far(&self, state: &State) -> Result<(), SolveError> {
        let scene = self.model.scene;
        if scene.contacts.is_empty() || !scene.mirrors.is_empty() {
            return Ok(());
        }
        match largest_turn(&scene.mesh, &state.displacement) {
            Some((body, angle)) if angle > TOO_FAR => Err(SolveError::TurnsFar {
                step: scene.steps[state.step].name.clone(),
                percent: match self.last.step == state.step {
                    true => 100.0 * self.last.time,
                    false => 0.0,
                },
                body: body.to_owned(),
                angle,
            }),
            _ => Ok(()),
        }
    }

    pub(super) fn accept(
        &mut self,
        trial: Point,
        evaluation: &Evaluation,
        last: bool,
    ) -> Result<(), SolveError> {
        let mut accepted = trial;
        self.history.advance(&mut accepted, evaluation);
        self.point = accepted;
        let mut timers = self.counters.timers;
        let state = timers.time(Phase::Recover, || {
            let (model, point) = (&self.model, &self.point);
            let with = (evaluation, self.sights.as_slice());
            let mut state = recovered_state(model, &self.history, point, with);
            let before = match self.last.displacement.is_empty() {
                true => Some(Energy::default()),
                false => self.last.energy,
            };
            state.energy = before.and_then(|energy| energy.after(model, &self.last, &state));
            state
        });
        self.counters.timers = timers;
        self.refuse_far(&state)?;
        self.observer
            .increment(&state)
            .map_err(SolveError::Observer)?;
        if last {
            let plastic = self.history.all_plastic(&self.model);
            self.finished.push(Kept::new(&state, plastic));
            self.states.push(state.clone());
        }
        self.last = state;
        Ok(())
    }

    pub(super) fn checkpoint(&mut self) -> Result<(), SolveError> {
        let (model, history, point) = (&self.model, &self.history, &self.point);
        let (finished, last, size) = (&self.finished, &self.last, self.size);
        let (expected, counters) = (&self.expected, &self.counters);
        let (companion, beside) = (self.companion.as_ref(), &self.beside);
        let make = || {
            let last = Kept::new(last, history.all_plastic(model));
            Restart::new(
                model,
                history,
                point,
                (finished, last),
                (beside.clone(), companion.map(|c| c.keep(model))),
                (expected.clone(), size),
                *counters,
            )
        };
        self.observer
            .checkpoint(&make)
            .map_err(SolveError::Observer)
    }
}
