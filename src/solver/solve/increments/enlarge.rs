//! Enlarging the working set.
//!
//! Before an increment is accepted the solution is looked at in full ([`Unforeseen`]). Where the working set was too small
//! the model is prepared anew: with more contact, after integrating it farther, or with more elements that may flow. If
//! nothing but flow was missed, and no node of these elements was condensed, it is enough to watch them.

use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::working_set::flow::Ahead;
use crate::solver::solve::working_set::unforeseen::Unforeseen;

impl Run<'_, '_> {
    /// What happens where the model was not prepared for it, now or in the next increment.
    pub(super) fn look(&mut self, trial: &Point, next: f64) -> Unforeseen {
        let (model, history) = (&self.model, &self.history);
        let ahead = self.ahead(trial.step, next);
        let look = || Unforeseen::new(model, history, &self.sights, trial, ahead);
        self.counters.timers.time(Phase::Recover, look)
    }

    /// What is known in `step` of the flow to come, where loads grow by the share `next` in the next increment.
    pub(super) fn ahead(&self, step: usize, next: f64) -> Ahead {
        let seen = self.beside.elastic.as_ref();
        match seen.is_some_and(|end| end.state.step == step) {
            _ if self.unloads(step) => Ahead::Less,
            true => Ahead::Known,
            false => Ahead::To(1.0 + next),
        }
    }

    /// Prepares the model anew; the next increment starts from `guess`.
    pub(super) fn prepare_for(
        &mut self,
        unforeseen: Unforeseen,
        guess: Option<&Point>,
    ) -> Result<(), SolveError> {
        let (integrate, flow_only) = (unforeseen.is_approach(), unforeseen.is_flow_only());
        let known = flow_only && self.model.keeps(&unforeseen.flow);
        self.expected.learn(unforeseen);
        if known {
            self.check_more_elements();
            self.guess = guess.cloned();
        } else {
            self.rebuild(integrate, guess)?;
        }
        let c = &self.counters;
        self.observer.message(&format!(
            "{} contact nodes may close, {} elements yield: {} of {} unknowns kept",
            c.contact_rows,
            self.model.yielding.len(),
            c.kept_equations,
            c.equations,
        ));
        Ok(())
    }

    /// An element that flows only has to be looked at, where its nodes were not condensed.
    fn check_more_elements(&mut self) {
        let beside = self.companion.as_mut().map(|c| &mut c.history);
        let histories: Vec<_> = [&mut self.history].into_iter().chain(beside).collect();
        let plastic: Vec<_> = (histories.iter().map(|h| h.all_plastic(&self.model))).collect();
        self.model.watch(&self.expected.flow);
        for (history, plastic) in histories.into_iter().zip(plastic) {
            history.place_plastic(&self.model, plastic);
        }
        self.counters.watched_elements = self.model.yielding.len();
    }

    /// What has flowed is taken for elastic again, as long as it does not: while loads are taken off hardly anything
    /// flows, and elastic bodies are condensed.
    pub(super) fn settle(&mut self) -> Result<(), SolveError> {
        self.expected.flow.clear();
        self.expected.divided = false;
        self.rebuild(false, None)
    }
}
