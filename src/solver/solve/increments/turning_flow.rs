//! Flow that turns, in a step before which steel flowed.
//!
//! Within one increment flow has one direction, whatever loads do meanwhile. Where it turns much, a solution in increments twice as large,
//! which may take all of it in one piece as well, tells of no error. A look ahead knows nothing of it, as it is of bodies that have not
//! flowed yet. But the increment itself tells, once it is solved, by how far stress turns from where it meets the yield surface.

use crate::model::material::j2::PlasticPoint;
use crate::model::material::mises;
use crate::model::mesh::hexahedron::volume;
use crate::model::state::State;
use crate::solver::solve::checkpoint::increment_plan::IncrementPlan;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::{Evaluation, PlasticAnswer};
use crate::solver::solve::increments::flow_plan::equal_shares;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::params::{EQUAL_STEP_SHARES, INCREMENT_GROWTH, LEAST_TURN, TURNED_FLOW};
use rayon::prelude::*;
use std::array::from_fn;

/// An element that flows in an increment.
struct Flowing {
    volume: f64,
    /// Stresses at its integration points before the increment,
    before: [[f64; 6]; 8],
    /// at its end if they did not flow in it, as strain is given,
    elastic: [[f64; 6]; 8],
    /// and as they are, as stress is given.
    after: [[f64; 6]; 8],
    /// What they flow at.
    flow_stress: [f64; 8],
    /// Plastic strain that they gain.
    gains: [f64; 8],
}

impl Flowing {
    /// By how much the stress on its straight way to one of these ends exceeds yield at a share of the increment, times the volume.
    fn excess(&self, end: &[[f64; 6]; 8], share: f64) -> f64 {
        let shares =
            (0..8).map(|k| mises(&between(&self.before[k], &end[k], share)) / self.flow_stress[k]);
        self.volume * (shares.fold(0.0, f64::max) - 1.0).max(0.0)
    }

    /// Plastic strain in a direction that the increment does not have from where it begins to flow, but at its end, times the volume: half of what it
    /// gains, by how far the direction of stress turns meanwhile.
    fn turned(&self) -> f64 {
        let of_point = |k: usize| {
            let begins = onset(&self.before[k], &self.elastic[k], self.flow_stress[k]);
            let from = direction(&between(&self.before[k], &self.elastic[k], begins));
            let to = direction(&self.after[k]);
            let apart: f64 = (0..6)
                .map(|i| (to[i] - from[i]).powi(2) * if i < 3 { 1.0 } else { 2.0 })
                .sum();
            0.5 * self.gains[k] * apart.sqrt()
        };
        self.volume / 8.0 * (0..8).map(of_point).sum::<f64>()
    }
}

/// Deviator of a stress over its size.
fn direction(stress: &[f64; 6]) -> [f64; 6] {
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    let deviator: [f64; 6] = from_fn(|i| stress[i] - if i < 3 { mean } else { 0.0 });
    let size = mises(stress) * (2.0f64 / 3.0).sqrt();
    deviator.map(|s| if size > 0.0 { s / size } else { 0.0 })
}

/// A stress on the straight way from one to another.
fn between(before: &[f64; 6], after: &[f64; 6], share: f64) -> [f64; 6] {
    from_fn(|k| before[k] + share * (after[k] - before[k]))
}

/// Share of the way between two stresses at which it leaves the yield surface.
fn onset(before: &[f64; 6], after: &[f64; 6], flow_stress: f64) -> f64 {
    const HALVINGS: i32 = 30;
    (1..=HALVINGS).fold(0.0, |begins, k| {
        let next = begins + 0.5f64.powi(k);
        let inside = mises(&between(before, after, next)) < flow_stress;
        if inside { next } else { begins }
    })
}

impl Run<'_, '_> {
    /// Divides an increment, `trial` with the displacements `u`, where its flow turns by more than [`TURNED_FLOW`]. Returns whether it did.
    pub(super) fn divide_turning_flow(
        &mut self,
        (trial, u): (&Point, &[[f64; 3]]),
        evaluation: &Evaluation,
    ) -> bool {
        let from = self.stands(trial.step);
        let length = trial.time - from;
        let has_flowed = |state: &State| state.energy.is_some_and(|energy| energy.plastic > 0.0);
        if !self.states.iter().any(has_flowed) || length < LEAST_TURN {
            return false;
        }
        let flowing = self.flowing((trial, u), evaluation);
        let turned: f64 = flowing.iter().map(Flowing::turned).sum();
        if turned <= TURNED_FLOW * self.plastic_strain(evaluation) {
            return false;
        }
        let mut ends = self.shares_of_flow(&flowing, [from, trial.time]);
        if ends.is_empty() {
            return false;
        }
        ends.push(trial.time);
        let plan = self
            .beside
            .plan
            .iter()
            .filter(|plan| plan.step == trial.step);
        let planned = plan.flat_map(|plan| &plan.ends);
        ends.extend(planned.filter(|end| **end > trial.time + EQUAL_STEP_SHARES));
        self.beside.plan = Some(IncrementPlan {
            step: trial.step,
            ends,
        });
        true
    }

    /// All plastic strain, times the volume.
    fn plastic_strain(&self, evaluation: &Evaluation) -> f64 {
        let watched = evaluation.plastic.iter();
        let watched = watched.map(|answer| (self.model.yielding[answer.index], &*answer.points));
        let settled = self.history.settled.elements.iter();
        let all = watched.chain(settled.map(|(element, points)| (*element, points)));
        let strain = |(element, points): (u32, &[PlasticPoint; 8])| {
            let volume = volume(&self.model.scene.mesh.corners(element as usize));
            volume / 8.0 * points.iter().map(|point| point.peeq).sum::<f64>()
        };
        all.map(strain).sum()
    }

    /// Times within an increment at which it has done equal shares of its flow: as if strain grew evenly, and as if stress did. The truth is
    /// between them: where loads are given and steel hardens little, elements flow late and far.
    fn shares_of_flow(&self, flowing: &[Flowing], [from, to]: [f64; 2]) -> Vec<f64> {
        let largest = INCREMENT_GROWTH * self.first_increment() / (to - from);
        let of_strain = |share: f64| flowing.iter().map(|e| e.excess(&e.elastic, share)).sum();
        let of_stress = |share: f64| flowing.iter().map(|e| e.excess(&e.after, share)).sum();
        let mut shares = equal_shares(of_strain, largest);
        shares.extend(equal_shares(of_stress, largest));
        shares.sort_unstable_by(f64::total_cmp);
        shares.dedup_by(|next, share| *next - *share < LEAST_TURN);
        let inner = shares
            .into_iter()
            .filter(|share| *share < 1.0 - EQUAL_STEP_SHARES);
        inner.map(|share| from + share * (to - from)).collect()
    }

    /// The elements that flow in it.
    fn flowing(&self, (trial, u): (&Point, &[[f64; 3]]), evaluation: &Evaluation) -> Vec<Flowing> {
        let (model, history) = (&self.model, &self.history);
        let scene = model.scene;
        let start = model.displacement(&self.point, &history.settled);
        let moments = [self.stands(trial.step), trial.time].map(|time| (trial.step, time));
        let flows = evaluation
            .plastic
            .par_iter()
            .filter(|answer| answer.flows());
        let of_element = |answer: &PlasticAnswer| {
            let element = model.yielding[answer.index];
            let body = scene.mesh.body_of(element as usize);
            let steel = &scene.materials[body];
            let points = history.plastic[answer.index].as_deref();
            let points: [PlasticPoint; 8] = points.copied().unwrap_or_default();
            let stress = |u: &[[f64; 3]], points, moment| {
                let local = scene.mesh.hexes[element as usize].map(|node| u[node as usize]);
                let free = model.free_strains(element, points, moment);
                model
                    .element(element)
                    .stress(&model.elastic[body], &local, &free)
            };
            Flowing {
                volume: volume(&scene.mesh.corners(element as usize)),
                before: stress(&start, points, moments[0]),
                elastic: stress(u, points, moments[1]),
                after: stress(u, *answer.points, moments[1]),
                flow_stress: points.map(|point| steel.flow_stress(point.peeq)),
                gains: from_fn(|k| answer.points[k].peeq - points[k].peeq),
            }
        };
        flows.map(of_element).collect()
    }
}
