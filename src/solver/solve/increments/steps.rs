//! Steps and increments: automatic size, and what follows an increment that was solved or was not.

use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::diagnosis::At;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::increments::turning_flow::Balanced;
use crate::solver::solve::newton::balance::balance_increment;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::params::{INCREMENT_GROWTH, LARGEST_INCREMENT, UNLOADING_ITERATIONS};
use crate::solver::solve::working_set::flow::Ahead;
use crate::solver::solve::working_set::unforeseen::Unforeseen;

impl Run<'_, '_> {
    /// Returns false where the observer cancelled.
    pub(super) fn all_steps(&mut self) -> Result<bool, SolveError> {
        let done = usize::from(self.point.time >= 1.0);
        for step in self.point.step + done..self.model.scene.steps.len() {
            if !self.one_step(step)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Balance at `trial`, if no element flows that is neither watched nor foreseen `ahead`.
    pub(super) fn balance(
        &mut self,
        trial: &mut Point,
        ahead: Ahead,
    ) -> Result<Evaluation, Stopped> {
        balance_increment(
            &self.model,
            &self.history,
            (trial, Goal::Foreseen(ahead)),
            &mut self.solver,
            self.observer,
            &mut self.counters,
        )
    }

    /// Solves one step, increment by increment, from where it stands. Returns false where the observer cancelled.
    fn one_step(&mut self, step: usize) -> Result<bool, SolveError> {
        let mut time = if self.point.step == step && self.point.time < 1.0 {
            self.point.time
        } else {
            0.0
        };
        if time == 0.0 {
            self.size = self.first_increment();
            self.point.cautious = false;
            self.counters.effort.before_step = self.counters.iterations;
        }
        let unloads = self.model.scene.unloads(step);
        let full = self.model.scene.before_certain_unloading();
        let may_stay = full.is_some_and(|full| step > full);
        if unloads && time == 0.0 && !self.history.is_virgin() {
            self.settle()?;
        }
        if (step, time) == (0, 0.0) {
            self.come_to_rest(self.size.min(self.relief(step, time)))?;
        }
        while time < 1.0 {
            let spent = self.counters.iterations - self.counters.effort.before_step;
            if may_stay && spent > UNLOADING_ITERATIONS {
                return Err(SolveError::Crawls {
                    step: self.model.scene.steps[step].name.clone(),
                    percent: 100.0 * time,
                    iterations: spent,
                });
            }
            let most = self.size.min(self.relief(step, time));
            let end = self.planned_end(step, time);
            // No sliver of an increment is left before the end.
            let target = if time + 1.001 * most >= end {
                end
            } else {
                time + most
            };
            let mut trial = self.predict(step, target);
            self.touch(&mut trial);
            let before = self.counters.iterations;
            let ahead = self.ahead(step, self.size / target);
            let result = self.balance(&mut trial, ahead);
            let iterations = self.counters.iterations - before;
            match result {
                Ok(evaluation) => {
                    if !std::mem::take(&mut self.cut) {
                        self.size = (INCREMENT_GROWTH * self.size)
                            .min(LARGEST_INCREMENT * self.first_increment());
                    }
                    // The working set may have been too small: then this increment is solved once more.
                    let (mut unforeseen, u) = self.look(&trial, self.size / target);
                    if !self.look_ahead(&mut unforeseen, &trial) {
                        return Ok(false);
                    }
                    if unforeseen.missed {
                        self.counters.effort.unforeseen += iterations;
                        self.prepare_for(unforeseen, Some(&trial))?;
                        self.size = target - time;
                        continue;
                    }
                    if let Some(error) = self.turns_far(step, &u) {
                        // Friction may hold a body in many places: with caution the nearest is found.
                        if trial.cautious {
                            return Err(error);
                        }
                        self.counters.effort.given_up += iterations;
                        self.point.cautious = true;
                        self.size = target - time;
                        continue;
                    }
                    let turning = self.turning((&trial, &u), &evaluation);
                    if self.divide_turning_flow(&trial, &turning) {
                        self.counters.effort.unforeseen += iterations;
                        self.size = target - time;
                        continue;
                    }
                    let mut balanced = Balanced {
                        trial,
                        u,
                        evaluation,
                        unforeseen,
                        lacking: Vec::new(),
                    };
                    if !self.turn_flow(&mut balanced, &turning, self.size / target) {
                        return Ok(false);
                    }
                    let unforeseen = self.accept(balanced, target >= 1.0)?;
                    (self.asked, self.held_back) = (false, false);
                    time = target;
                    self.accompany();
                    // What only the next increment needs is prepared after this one was accepted.
                    if !unforeseen.is_empty() {
                        self.prepare_for(unforeseen, None)?;
                    }
                    if time >= 1.0 && !self.bring_companion() {
                        return Ok(false);
                    }
                    self.checkpoint()?;
                }
                Err(Stopped {
                    why: Failure::Cancelled,
                    ..
                }) => return Ok(false),
                Err(Stopped {
                    why: Failure::UnforeseenFlow,
                    flowing,
                }) => {
                    self.prepare_for(Unforeseen::of_flow(flowing), Some(&trial))?;
                    self.size = target - time;
                }
                Err(stopped) => {
                    self.counters.effort.given_up += iterations;
                    if !self.model.spare.is_empty() && (!unloads || self.cut) {
                        // Perhaps a body is held by contact that was left out. As a load is taken off that is the last to
                        // be thought of.
                        self.expected.contact = f64::INFINITY;
                        self.rebuild(false, None)?;
                    }
                    let at = At {
                        step,
                        time,
                        iterations,
                    };
                    if !self.try_otherwise(&stopped, &at, target)? {
                        return Ok(false);
                    }
                }
            }
        }
        Ok(true)
    }
}
