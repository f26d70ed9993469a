//! Keeping the second solution beside the first.

use crate::solver::solve::checkpoint::companion::Lacking;
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::increments::companion::Companion;
use crate::solver::solve::increments::flowing::{Flowing, add_lacking, add_to, flowing};
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::balance::balance_increment;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::recovery::state::recovered_state;
use std::mem::take;
use std::sync::Arc;

impl Run<'_, '_> {
    /// Takes note of an accepted increment, and of what flows in it where steel flowed in a step before.
    pub(super) fn accompany(&mut self, flowing: &[Flowing]) {
        let alike = self.history.is_virgin() && !self.model.scene.rubs();
        let Some(companion) = &mut self.companion else {
            return;
        };
        if alike {
            // Both are the same as long as nothing has yielded or rubbed.
            *companion = Companion::at(&self.point, &self.history);
        } else {
            companion.passed.push(self.point.clone());
            add_lacking(&mut companion.lacking, flowing);
        }
    }

    /// Brings the companion to the end of the step. Returns false where the observer cancelled.
    pub(super) fn bring_companion(&mut self) -> bool {
        let Some(mut companion) = self.companion.take() else {
            return true;
        };
        let passed = take(&mut companion.passed);
        let lacking = take(&mut companion.lacking);
        let turns = !lacking.is_empty();
        // One increment alone is no larger than that of the first solution.
        let tells = passed.len() > 1 || !self.beside.doubled.is_empty();
        // Every second one; the last in any case. Where their number is odd the first of these takes three.
        let odd = passed.len() % 2;
        let last = passed.len().wrapping_sub(1);
        let ends = passed.into_iter().enumerate();
        let ends = ends.filter(|(i, _)| *i == last || (*i > 0 && i % 2 != odd));
        let mut own = Lacking::new();
        let mut evaluation = None;
        for (_, trial) in ends {
            match self.follow(&mut companion, trial, turns.then_some(&mut own)) {
                Followed::To(found) => evaluation = Some(found),
                Followed::Cancelled => return false,
                Followed::Lost => return true,
            }
        }
        if let Some(evaluation) = evaluation.filter(|_| tells) {
            self.keep_second(&companion, &evaluation);
        }
        if turns {
            // What it lacks itself as its flow turns, twice what the first solution does: where all of a step flows in one increment both
            // may have taken the same one.
            add_to(&mut own, lacking, -2.0);
            companion.gains(&self.model, &own);
            let point = companion.point.clone();
            match self.follow(&mut companion, point, None) {
                Followed::To(evaluation) => self.keep_second(&companion, &evaluation),
                Followed::Cancelled => return false,
                Followed::Lost => return true,
            }
        }
        self.companion = Some(companion);
        true
    }

    /// Keeps where the companion stands, for what is said of the increments.
    fn keep_second(&mut self, companion: &Companion, evaluation: &Evaluation) {
        let (model, history) = (&self.model, &companion.history);
        let with = (evaluation, self.sights.as_slice());
        let u = model.displacement(&companion.point, &history.settled);
        let state = recovered_state(model, history, (&companion.point, u), with);
        let plastic = history.all_plastic(model);
        self.beside
            .doubled
            .push(Arc::new(Kept::new(&state, plastic)));
    }

    /// Brings the companion to balance at `trial`, and adds to `lacking` what its flow lacks as it turns on the way.
    fn follow(
        &mut self,
        companion: &mut Companion,
        mut trial: Point,
        lacking: Option<&mut Lacking>,
    ) -> Followed {
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
                let (model, history) = (&self.model, &companion.history);
                if let Some(lacking) = lacking {
                    let u = model.displacement(&trial, &history.settled);
                    let with = (&trial, u.as_slice());
                    let flowing = flowing((model, history), &companion.point, with, &found);
                    add_lacking(lacking, &flowing);
                }
                companion.history.advance(&mut trial, &found);
                companion.point = trial;
                Followed::To(found)
            }
            Err(Stopped {
                why: Failure::Cancelled,
                ..
            }) => Followed::Cancelled,
            Err(_) => {
                self.observer.message(
                    "the second solution, in increments twice as large, did not converge: what the \
                     increments are worth is not known",
                );
                Followed::Lost
            }
        }
    }
}

/// What came of an increment of the companion.
enum Followed {
    To(Evaluation),
    Cancelled,
    /// It is not in balance.
    Lost,
}
