//! Enlarging the working set.
//!
//! Before an increment is accepted the solution is looked at in full ([`Unforeseen`]). Where the working set was too small
//! the model is prepared anew: with more contact, after integrating it farther, or with more elements that may flow. If
//! nothing but flow was missed, and no node of these elements was condensed, it is enough to watch them; so little costs this
//! that the iterations look for it as soon as balance is near ([`Goal::Foreseen`](crate::solver::solve::newton::goal::Goal)).

use crate::ground::geometry::Vec3;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::checkpoint::timers::Phase;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::working_set::flow::Ahead;
use crate::solver::solve::working_set::unforeseen::Unforeseen;

impl Run<'_, '_> {
    /// Checks a converged increment: what happens where the model was not prepared for it, now or in the next increment,
    /// which will be larger by the share `next` of the load. Also returns the displacements of all nodes.
    pub(super) fn look(&mut self, trial: &Point, next: f64) -> (Unforeseen, Vec<Vec3>) {
        let (model, history) = (&self.model, &self.history);
        let ahead = self.ahead(trial.step, next);
        let look = || {
            let u = model.displacement(trial, &history.settled);
            let unforeseen = Unforeseen::new(model, history, &self.sights, (trial, &u), ahead);
            (unforeseen, u)
        };
        self.counters.timers.time(Phase::Recover, look)
    }

    /// What is known in `step` of the flow to come, where loads grow by the share `next` in the next increment.
    pub(super) fn ahead(&self, step: usize, next: f64) -> Ahead {
        let seen = self.beside.elastic.as_ref();
        if self.model.scene.unloads(step) {
            Ahead::Less
        } else if seen.is_some_and(|end| end.state.step == step) {
            Ahead::Known
        } else {
            Ahead::To(1.0 + next)
        }
    }

    /// Enlarges the working set by what was unforeseen; the next increment starts from `guess`, or from the last accepted
    /// state where there is none.
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

    /// Watches more elements without preparing the model anew: none of their nodes was condensed. Plastic strains move
    /// from the settled elements to the watched ones, of the companion too.
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

    /// Before a load is taken off, takes all elements for elastic again. Hardly anything flows while loads become
    /// smaller, so that the elements can be condensed; their plastic strain acts as a load
    /// ([`crate::solver::solve::model::settled`]). One that flows after all is found by the next look.
    pub(super) fn settle(&mut self) -> Result<(), SolveError> {
        self.expected.flow.clear();
        self.expected.divided = false;
        self.rebuild(false, None)
    }
}
