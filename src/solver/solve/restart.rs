//! What a solution needs to go on from an accepted increment, as if it had never stopped.

use super::counters::Counters;
use super::driver::KeptCompanion;
use super::foresight::Expected;
use super::history::{History, Plastic};
use super::model::Model;
use super::newton::Point;
use super::state::stresses;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::contact::law::Node;
use crate::solver::solve::params::EQUAL_STEP_SHARES;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An accepted increment with all that the next one depends on.
///
/// Stresses are not kept: they follow from displacements and plastic strains.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Restart {
    /// The ends of the finished steps.
    pub(super) finished: Vec<Kept>,
    pub(super) last: Kept,
    pub(super) beside: Beside,
    pub(super) companion: Option<KeptCompanion>,
    touching: Vec<Touching>,
    pub(super) expected: Expected,
    /// Share of the step that the next increment tries.
    pub(super) size: f64,
    cautious: bool,
    pub(super) counters: Counters,
}

/// What was found beside the solution.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Beside {
    /// The end of a step if no steel had yielded.
    pub elastic: Option<Kept>,
    pub plan: Option<IncrementPlan>,
    /// The ends of steps in increments twice as large.
    pub doubled: Vec<Kept>,
}

/// Where increments of a step have to end.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct IncrementPlan {
    pub step: usize,
    pub ends: Vec<f64>,
}

impl IncrementPlan {
    /// Equal increments between two shares of `step`, none of them larger than `most`.
    pub fn even(step: usize, [from, to]: [f64; 2], most: f64) -> Self {
        let parts = ((to - from) / most - EQUAL_STEP_SHARES).ceil().max(1.0) as usize;
        let part = (to - from) / parts as f64;
        let inner = (1..parts).map(|k| from + k as f64 * part);
        Self {
            step,
            ends: inner.chain([to]).collect(),
        }
    }
}

/// A state without its stresses and plastic strains, and what these follow from.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Kept {
    pub state: State,
    pub plastic: Plastic,
}

/// Memory of a contact row.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Touching {
    pair: u32,
    node: u32,
    law: Node,
    slip_origin: [f64; 2],
    slip: f64,
}

/// Why a restart does not belong to a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the increment to go on from has {what} that the scene does not have")]
pub struct Stranger {
    what: &'static str,
}

impl Kept {
    pub fn new(state: &State, plastic: Plastic) -> Self {
        Self {
            state: State {
                step: state.step,
                time: state.time,
                displacement: state.displacement.clone(),
                stress: Vec::new(),
                peeq: Vec::new(),
                contacts: state.contacts.clone(),
                planes: state.planes.clone(),
                energy: state.energy,
            },
            plastic,
        }
    }

    /// The whole state.
    pub fn restore(&self, model: &Model) -> State {
        let displacement = &self.state.displacement;
        let (stress, peeq) = stresses(model, &self.plastic, displacement);
        State {
            stress,
            peeq,
            ..self.state.clone()
        }
    }

    fn check(&self, scene: &Scene) -> Result<(), Stranger> {
        let state = &self.state;
        let element = |(e, _): &(u32, _)| (*e as usize) < scene.mesh.hexes.len();
        let fit = [
            (state.step < scene.steps.len(), "a step"),
            (
                state.displacement.len() == scene.mesh.points.len(),
                "a number of nodes",
            ),
            (
                state.contacts.len() == scene.contacts.len(),
                "a number of contact pairs",
            ),
            (
                state.planes.len() == scene.rigid_planes.len(),
                "a number of rigid planes",
            ),
            (self.plastic.iter().all(element), "elements"),
        ];
        match fit.into_iter().find(|(fits, _)| !fits) {
            Some((_, what)) => Err(Stranger { what }),
            None => Ok(()),
        }
    }
}

impl Restart {
    /// Where the solution stands that goes on after `last`, in increments of `size`.
    pub(super) fn new(
        model: &Model,
        history: &History,
        point: &Point,
        (finished, last): (&[Kept], Kept),
        (beside, companion): (Beside, Option<KeptCompanion>),
        (expected, size): (Expected, f64),
        counters: Counters,
    ) -> Self {
        let rows = model.rows.iter().enumerate();
        Self {
            finished: finished.to_vec(),
            last,
            beside,
            companion,
            touching: rows
                .map(|(i, r)| Touching {
                    pair: r.pair as u32,
                    node: r.row.node,
                    law: point.nodes[i],
                    slip_origin: history.slip_origin[i],
                    slip: history.slip[i],
                })
                .collect(),
            expected,
            size,
            cautious: point.cautious,
            counters,
        }
    }

    /// Does it belong to `scene`?
    ///
    /// # Errors
    /// [`Stranger`] says what does not fit.
    pub fn check(&self, scene: &Scene) -> Result<(), Stranger> {
        let beside = self.beside.doubled.iter().chain(&self.beside.elastic);
        for kept in self.finished.iter().chain([&self.last]).chain(beside) {
            kept.check(scene)?;
        }
        let exists = |e: u32| (e as usize) < scene.mesh.hexes.len();
        let flow = self.expected.flow.iter().map(|e| (0, *e));
        let beside = self.companion.iter().flat_map(KeptCompanion::contents);
        match (flow.chain(beside)).all(|(step, e)| exists(e) && step < scene.steps.len()) {
            true => Ok(()),
            false => Err(Stranger { what: "elements" }),
        }
    }

    /// Unknowns, contact and history, for a model that was prepared for what is expected here.
    pub(super) fn place(&self, model: &Model) -> (Point, History) {
        let displacement = &self.last.state.displacement;
        let known: BTreeMap<(usize, u32), &Touching> = (self.touching.iter())
            .map(|t| ((t.pair as usize, t.node), t))
            .collect();
        let touching: Vec<Touching> = (model.rows.iter())
            .map(|r| match known.get(&(r.pair, r.row.node)) {
                Some(known) => **known,
                None => {
                    let [_, s, t] = r.relative(displacement);
                    Touching {
                        pair: r.pair as u32,
                        node: r.row.node,
                        law: Node::default(),
                        slip_origin: [s, t],
                        slip: 0.0,
                    }
                }
            })
            .collect();
        let slip = touching.iter().map(|t| (t.slip_origin, t.slip)).unzip();
        let history = History::new(model, self.last.plastic.clone(), slip);
        let point = Point {
            step: self.last.state.step,
            time: self.last.state.time,
            x: model.unknowns(displacement),
            nodes: touching.iter().map(|t| t.law).collect(),
            cautious: self.cautious,
        };
        (point, history)
    }

    /// The increment that it goes on after: index of its step, and share of that step.
    pub fn after(&self) -> (usize, f64) {
        (self.last.state.step, self.last.state.time)
    }
}
