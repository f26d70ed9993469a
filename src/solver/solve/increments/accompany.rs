//! Keeping the second solution beside the first.

use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::increments::companion::Companion;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::balance::balance_increment;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::recovery::state::recovered_state;
use std::mem::take;
use std::sync::Arc;

impl Run<'_, '_> {
    /// Takes note of an accepted increment.
    pub(super) fn accompany(&mut self) {
        let alike = self.history.is_virgin() && !self.model.scene.rubs();
        let Some(companion) = &mut self.companion else {
            return;
        };
        if alike {
            // Both are the same as long as nothing has yielded or rubbed.
            *companion = Companion::at(&self.point, &self.history);
        } else {
            companion.passed.push(self.point.clone());
        }
    }

    /// Brings the companion to the end of the step. Returns false where the observer cancelled.
    pub(super) fn bring_companion(&mut self) -> bool {
        let Some(mut companion) = self.companion.take() else {
            return true;
        };
        let passed = take(&mut companion.passed);
        let tells = passed.len() > 1 || !self.beside.doubled.is_empty();
        // Every second one; the last in any case. Where their number is odd the first of these takes three.
        let odd = passed.len() % 2;
        let last = passed.len().wrapping_sub(1);
        let ends = passed.into_iter().enumerate();
        let ends = ends.filter(|(i, _)| *i == last || (*i > 0 && i % 2 != odd));
        let mut evaluation = None;
        for (_, mut trial) in ends {
            let before = self.counters.iterations;
            let balanced = balance_increment(
                &self.model,
                &companion.history,
                (&mut trial, Goal::Estimate),
                &mut self.solver,
                self.observer,
                &mut self.counters,
            );
            self.counters.effort.second += self.counters.iterations - before;
            match balanced {
                Ok(found) => {
                    companion.history.advance(&mut trial, &found);
                    companion.point = trial;
                    evaluation = Some(found);
                }
                Err(Stopped {
                    why: Failure::Cancelled,
                    ..
                }) => return false,
                Err(_) => {
                    self.observer.message(
                        "the second solution, in increments twice as large, did not converge: what the \
                         increments are worth is not known",
                    );
                    return true;
                }
            }
        }
        // One increment alone is no larger than that of the first solution.
        if let Some(evaluation) = evaluation.filter(|_| tells) {
            let (model, history) = (&self.model, &companion.history);
            let with = (&evaluation, self.sights.as_slice());
            let u = model.displacement(&companion.point, &history.settled);
            let state = recovered_state(model, history, (&companion.point, u), with);
            let plastic = history.all_plastic(model);
            let kept = Arc::new(Kept::new(&state, plastic));
            self.beside.doubled.push(kept);
        }
        self.companion = Some(companion);
        true
    }
}
