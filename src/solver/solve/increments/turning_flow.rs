//! Flow that turns, in a step after the first: in that all loads grow together.
//!
//! Within one increment flow has one direction, whatever loads do meanwhile. Where it turns much, a solution in increments twice as large,
//! which may take all of it in one piece as well, tells of no error. A look ahead knows nothing of it, as it is of bodies that have not
//! flowed yet. But the increment itself tells, once it is solved, by how far stress turns from where it meets the yield surface.

use crate::ground::geometry::Vec3;
use crate::model::material::j2::PlasticPoint;
use crate::model::mesh::hexahedron::volume;
use crate::solver::solve::checkpoint::increment_plan::IncrementPlan;
use crate::solver::solve::checkpoint::plastic::PlasticStrains;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::increments::flow_plan::equal_shares;
use crate::solver::solve::increments::flowing::{Flowing, lacking};
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::newton::failure::{Failure, Stopped};
use crate::solver::solve::params::{
    EQUAL_STEP_SHARES, INCREMENT_GROWTH, LEAST_TURN, LITTLE_TURNED, TURNED_FLOW,
};
use crate::solver::solve::working_set::unforeseen::Unforeseen;

/// An increment that is in balance.
pub struct Balanced {
    pub trial: Point,
    pub u: Vec<Vec3>,
    pub evaluation: Evaluation,
    /// What the model was not prepared for.
    pub unforeseen: Unforeseen,
    /// Plastic strain that it was given as its flow turns.
    pub lacking: PlasticStrains,
}

/// The elements that flow in an increment.
#[derive(Default)]
pub struct Turning {
    flowing: Vec<Flowing>,
    /// Of all plastic strain, what has the direction of the end of the increment and not of its course.
    share: f64,
}

impl Run<'_, '_> {
    /// How flow turns in an increment, `trial` with the displacements `u`, in a step after the first.
    pub(super) fn turning(&self, with: (&Point, &[Vec3]), evaluation: &Evaluation) -> Turning {
        if self.states.is_empty() {
            return Turning::default();
        }
        let flowing = self.flowing(with, evaluation);
        let turned: f64 = flowing.iter().map(Flowing::turned).sum();
        let share = if turned > 0.0 {
            turned / self.plastic_strain(evaluation)
        } else {
            0.0
        };
        Turning { flowing, share }
    }

    /// Divides an increment, `trial`, where its flow turns by more than [`TURNED_FLOW`]. Returns whether it did.
    pub(super) fn divide_turning_flow(&mut self, trial: &Point, turning: &Turning) -> bool {
        let from = self.stands(trial.step);
        if turning.share <= TURNED_FLOW || trial.time - from < LEAST_TURN {
            return false;
        }
        let mut ends = self.shares_of_flow(&turning.flowing, [from, trial.time]);
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

    /// Solves an increment once more with the plastic strain that it [lacks](Flowing::lacks) as its flow turns, so that its flow has the mean direction of its
    /// course. What does not come to balance so, or asks for more to be prepared, stays as it was. Returns false where the observer cancelled.
    pub(super) fn turn_flow(
        &mut self,
        balanced: &mut Balanced,
        turning: &Turning,
        next: f64,
    ) -> bool {
        if turning.share <= LITTLE_TURNED {
            return true;
        }
        let lacking = lacking(&turning.flowing);
        self.history.gain(&self.model, &lacking, 1.0);
        let mut trial = balanced.trial.clone();
        let before = self.counters.iterations;
        let ahead = self.ahead(trial.step, next);
        let result = self.balance(&mut trial, ahead);
        self.counters.effort.unforeseen += self.counters.iterations - before;
        let cancelled = matches!(
            result,
            Err(Stopped {
                why: Failure::Cancelled,
                ..
            })
        );
        if let Ok(evaluation) = result {
            let (unforeseen, u) = self.look(&trial, next);
            if !unforeseen.missed {
                *balanced = Balanced {
                    trial,
                    u,
                    evaluation,
                    unforeseen,
                    lacking,
                };
                return true;
            }
        }
        self.history.gain(&self.model, &lacking, -1.0);
        !cancelled
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
}
