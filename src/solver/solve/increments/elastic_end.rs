//! A look at the end of the step as if no steel yielded.
//!
//! As long as nothing has flowed the condensed model is elastic, and solves to full load for next to
//! nothing. From there the elements are known that will flow, the contact to begin with at full load,
//! and the elastic peaks.

use crate::model::mesh::hexahedron::volume;
use crate::solver::solve::checkpoint::increment_plan::IncrementPlan;
use crate::solver::solve::checkpoint::kept::Kept;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::equilibrium::history::{History, start_from};
use crate::solver::solve::increments::flow_plan::{Growth, flow_ends};
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::balance::balance_increment;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::newton::goal::Goal;
use crate::solver::solve::params::{CONTACT_OF_FLOW, INCREMENT_GROWTH, LARGEST_INCREMENT};
use crate::solver::solve::recovery::state::recovered_state;
use crate::solver::solve::working_set::flow::{Ahead, flow_to_come};
use crate::solver::solve::working_set::overlap::farthest_closed;
use crate::solver::solve::working_set::shares_of_yield::shares_of_yield;
use crate::solver::solve::working_set::unforeseen::Unforeseen;
use std::mem::{swap, take};

impl Run<'_, '_> {
    /// Looks ahead where the elements of `unforeseen` are the first to flow in all; they give way to those
    /// that will, and for the rest of the step none are guessed any more. Where the elastic model does not
    /// converge all stays as it was. Returns false where the observer cancelled.
    pub(super) fn look_ahead(&mut self, unforeseen: &mut Unforeseen, trial: &Point) -> bool {
        let virgin = self.history.is_virgin();
        let unknown = matches!(self.ahead(trial.step, 0.0), Ahead::To(_));
        if !unknown || unforeseen.flow.is_empty() || !virgin {
            return true;
        }
        // Elements of small bodies are watched from the start: here they are elastic like all others.
        let watched = take(&mut self.model.yielding);
        let mut plastic = take(&mut self.history.plastic);
        let mut end = Point {
            time: 1.0,
            ..trial.clone()
        };
        let mut balance = |end: &mut Point| {
            balance_increment(
                &self.model,
                &self.history,
                (end, Goal::Balance),
                &mut self.solver,
                self.observer,
                &mut self.counters,
            )
        };
        let mut balanced = balance(&mut end);
        if matches!(&balanced, Err(stopped) if stopped.why != Failure::Cancelled) && !end.cautious {
            end.cautious = true;
            balanced = balance(&mut end);
        }
        end.cautious = trial.cautious;
        if let Ok(evaluation) = &balanced {
            let model = &self.model;
            let settled = &self.history.settled;
            let u = model.displacement(&end, settled);
            let looked_at = (&end, u.as_slice());
            let contact =
                Unforeseen::new(model, &self.history, &self.sights, looked_at, Ahead::Less);
            if contact.is_flow_only() {
                let shares = |p: &Point, u: &[[f64; 3]]| {
                    shares_of_yield(model, settled, (u, (p.step, p.time)))
                };
                let now = shares(trial, &model.displacement(trial, settled));
                let then = shares(&end, &u);
                unforeseen.flow = flow_to_come(&then);
                // The model is prepared anew for the flow: then for the contact, too, that it will make.
                let closes = CONTACT_OF_FLOW * farthest_closed(model, &end);
                self.expected.contact = self.expected.contact.max(closes);
                let corners = |element| model.scene.mesh.corners(element as usize);
                let growth = now.iter().zip(&then).map(|((element, now), (_, then))| {
                    Growth::new(volume(&corners(*element)), (trial.time, *now), *then)
                });
                let growth: Vec<_> = growth.collect();
                self.beside.plan = Some(IncrementPlan {
                    step: trial.step,
                    ends: flow_ends(&growth, INCREMENT_GROWTH * self.first_increment()),
                });
                // From there on increments are as large as they have to be.
                self.size = LARGEST_INCREMENT * self.first_increment();
                let with = (evaluation, self.sights.as_slice());
                let state = recovered_state(model, &self.history, (&end, u), with);
                self.beside.elastic = Some(Kept::new(&state, Vec::new()));
                self.beside.elastic_doubled = None;
                if self.model.scene.rubs() {
                    self.end_elastically_by_way_of(trial, (&end, evaluation));
                }
                self.end = Some(end);
            } else {
                // First for a strip that outgrows what was prepared for it: the next look knows what flows.
                unforeseen.flow.clear();
                unforeseen.add_contact(contact);
            }
        } else if unforeseen.missed {
            // Nothing is known of the flow to come: one increment of it would say nothing of its own error.
            let (from, to) = (self.stands(trial.step), trial.time);
            self.beside.plan = Some(IncrementPlan::even(
                trial.step,
                [from, to],
                0.5 * (to - from),
            ));
        }
        swap(&mut self.history.plastic, &mut plastic);
        self.model.yielding = watched;
        !matches!(
            balanced,
            Err(Stopped {
                why: Failure::Cancelled,
                ..
            })
        )
    }

    /// Finds the elastic end of the step once more, in two increments: what bodies that rub come to depends
    /// on the way. That of one increment, `end`, tells what the two are worth. Where they do not converge `end`
    /// stands alone.
    fn end_elastically_by_way_of(&mut self, trial: &Point, (end, at_end): (&Point, &Evaluation)) {
        let mut balance = |history: &History, point: &mut Point| {
            balance_increment(
                &self.model,
                history,
                (point, Goal::Balance),
                &mut self.solver,
                self.observer,
                &mut self.counters,
            )
        };
        let mut history = self.history.clone();
        let mut way = trial.clone();
        let Ok(on_the_way) = balance(&history, &mut way) else {
            return;
        };
        history.slide(&mut way, &on_the_way);
        let mut point = end.clone();
        start_from(&mut point, at_end);
        let Ok(evaluation) = balance(&history, &mut point) else {
            return;
        };
        let with = (&evaluation, self.sights.as_slice());
        let u = self.model.displacement(&point, &history.settled);
        let state = recovered_state(&self.model, &history, (&point, u), with);
        let of_two = Kept::new(&state, Vec::new());
        self.beside.elastic_doubled = self.beside.elastic.replace(of_two);
    }
}
