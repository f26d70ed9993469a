//! What a solution needs to go on from an accepted increment as if it had never stopped; without the second solution
//! where the model is prepared otherwise than it was.

use crate::model::scene::Scene;
use crate::solver::contact::law::Node;
use crate::solver::solve::checkpoint::companion::KeptCompanion;
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::checkpoint::increment_plan::IncrementPlan;
use crate::solver::solve::checkpoint::kept::{Kept, Stranger};
use crate::solver::solve::checkpoint::point::Point;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// An accepted increment with all that the next one depends on.
///
/// Stresses are not kept: they follow from displacements and plastic strains.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Restart {
    /// The ends of the finished steps; shared, as every later increment has the same ones.
    pub(in crate::solver::solve) finished: Vec<Arc<Kept>>,
    pub(in crate::solver::solve) last: Kept,
    pub(in crate::solver::solve) beside: Beside,
    pub(in crate::solver::solve) companion: Option<KeptCompanion>,
    pub(in crate::solver::solve) touching: Vec<Touching>,
    pub(in crate::solver::solve) expected: Expected,
    /// Share of the step that the next increment tries.
    pub(in crate::solver::solve) size: f64,
    pub(in crate::solver::solve) cautious: bool,
    pub(in crate::solver::solve) counters: Counters,
}

/// What was found beside the solution.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(in crate::solver::solve) struct Beside {
    /// The end of a step if no steel had yielded.
    pub elastic: Option<Kept>,
    /// The same in increments twice as large.
    pub elastic_doubled: Option<Kept>,
    pub plan: Option<IncrementPlan>,
    /// The ends of steps in increments twice as large.
    pub doubled: Vec<Arc<Kept>>,
    /// The end of the step if no steel yielded, from which its last increment starts.
    pub end: Option<Point>,
}

/// Memory of a contact row.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Touching {
    pub(in crate::solver::solve) pair: u32,
    pub(in crate::solver::solve) node: u32,
    pub(in crate::solver::solve) law: Node,
    pub(in crate::solver::solve) slip_origin: [f64; 2],
    pub(in crate::solver::solve) slip: f64,
}

impl Restart {
    /// Does it belong to `scene`?
    ///
    /// # Errors
    /// [`Stranger`] says what does not fit.
    pub fn check(&self, scene: &Scene) -> Result<(), Stranger> {
        let beside = self.beside.doubled.iter().map(AsRef::as_ref);
        let beside = beside
            .chain(&self.beside.elastic)
            .chain(&self.beside.elastic_doubled);
        let finished = self.finished.iter().map(AsRef::as_ref);
        for kept in finished.chain([&self.last]).chain(beside) {
            kept.check(scene)?;
        }
        let exists = |e: u32| (e as usize) < scene.mesh.hexes.len();
        let flow = self.expected.flow.iter().map(|e| (0, *e));
        let companion = self.companion.iter().flat_map(KeptCompanion::contents);
        let end = self.beside.end.iter().map(|end| (end.step, 0));
        if (flow.chain(companion).chain(end)).all(|(step, e)| exists(e) && step < scene.steps.len())
        {
            Ok(())
        } else {
            Err(Stranger { what: "elements" })
        }
    }

    /// The increment that it goes on after: index of its step, and share of that step.
    pub fn after(&self) -> (usize, f64) {
        (self.last.state.step, self.last.state.time)
    }
}
