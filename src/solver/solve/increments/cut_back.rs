//! Other ways to an increment that has failed, and smaller increments.

use crate::solver::solve::checkpoint::increment_plan::IncrementPlan;
use crate::solver::solve::equilibrium::evaluation::much_flows;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::diagnosis::{At, describe, diagnose};
use crate::solver::solve::increments::no_balance::no_balance;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::failure::Stopped;
use crate::solver::solve::params::{INCREMENTS_TO_LIMIT, PLASTIC_LIMIT_KNOWN};

impl Run<'_, '_> {
    /// After an increment to `target` has failed: makes another way to it, or a smaller increment, ready. False where
    /// the observer cancelled.
    pub(super) fn try_otherwise(
        &mut self,
        stopped: &Stopped,
        at: &At,
        target: f64,
    ) -> Result<bool, SolveError> {
        let (step, time) = (at.step, at.time);
        // Where little flows it is not the plastic limit that takes balance away: a body may be free.
        let floats = !much_flows(&self.model, &stopped.flowing);
        let begins = (step, time) == (0, 0.0);
        if floats && !self.asked {
            self.asked = true;
            if let Some(error) = no_balance(&self.model, (step, target), time) {
                return Err(error);
            }
        }
        self.size = target - time;
        // What was in balance a little before is a better guess than springs find: they come in where nothing
        // was, or where increments cannot be smaller.
        let least = self.model.scene.controls.smallest_increment;
        let least = if floats {
            least
        } else {
            least
                .max(PLASTIC_LIMIT_KNOWN)
                .max((1.0 - time) / INCREMENTS_TO_LIMIT)
        };
        let smallest = 0.5 * self.size < least;
        if floats && !self.held_back && (begins || (smallest && self.point.cautious)) {
            self.held_back = true;
            return Ok(self.hold_back(step, target));
        }
        // A load that is taken off opens contact and turns friction round. Half of what was too much at once needs a few
        // iterations, with caution it takes many, and so do all increments that follow.
        let halves = self.model.scene.unloads(step) && !smallest && !self.cut;
        // Caution with friction does not help where steel gives way.
        if !(self.point.cautious || halves) && (floats || smallest) {
            self.point.cautious = true;
            return Ok(true);
        }
        if smallest && begins && floats && !std::mem::replace(&mut self.tried_whole, true) {
            // Next to no load closes a node or two of a mesh, on which bodies rock. More load closes more of them.
            self.size = 1.0;
            (self.held_back, self.point.cautious) = (false, false);
            self.solver.forget();
            self.come_to_rest(self.size)?;
            self.observer.message(
                "a small share of the load closes too few nodes to hold the bodies: the step is tried as a whole",
            );
            return Ok(true);
        }
        if smallest {
            return Err(diagnose(&self.model, stopped, at));
        }
        self.size *= 0.5;
        self.cut = true;
        if !floats {
            // What was too much for the steel once will not become less.
            self.beside.plan = Some(IncrementPlan::even(step, [time, 1.0], self.size));
        }
        self.counters.cut_backs += 1;
        self.solver.forget();
        self.observer.message(&format!(
            "cut back to {:.3} % of the step: {}",
            100.0 * (time + self.size),
            describe(&stopped.why)
        ));
        Ok(true)
    }
}
