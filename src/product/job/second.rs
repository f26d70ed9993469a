//! What is solved beside the case itself: the peaks without plasticity.

use super::outcome::{Outcome, reported};
use crate::answer::certify::Figure;
use crate::answer::results::peaks::{BodyPeaks, peaks_in};
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::summary::ElasticTwin;
use crate::solver::solve::{self, Observer, Solution};

/// Peaks of the same scene without plasticity, where it has yielded. The answer stands without
/// them, so what goes wrong here is told and no error.
pub fn elastic_peaks(
    scene: &Scene,
    solution: &Solution,
    observer: &mut dyn Observer,
) -> Option<ElasticPeaks> {
    let yielded = reported(scene, solution)
        .peeq
        .iter()
        .flatten()
        .any(|p| *p > 0.0);
    if !yielded || !solution.complete {
        return None;
    }
    let step = reported(scene, solution).step;
    if let Some(state) = solution.elastic.as_ref().filter(|e| e.step == step) {
        return Some(ElasticPeaks::of(
            scene,
            state,
            solution.elastic_doubled.as_ref(),
        ));
    }
    observer
        .message("something yielded: solving once more without plasticity, for the elastic peaks");
    let mut elastic = scene.clone();
    elastic.controls.plasticity = false;
    elastic.steps.truncate(step + 1);
    let solution = match solve::solve(&mut elastic, &mut Stoppable(observer)) {
        Ok(solution) => solution,
        Err(error) => {
            observer.message(&format!("no elastic peaks: {error}"));
            return None;
        }
    };
    if !solution.complete {
        return None;
    }
    Some(ElasticPeaks::of(
        &elastic,
        &solution.last,
        solution.doubled.last(),
    ))
}

/// Peaks of an elastic solution, in the order of the bodies.
#[derive(Debug, Clone)]
pub struct ElasticPeaks {
    pub own: Vec<BodyPeaks>,
    /// In increments twice as large, where that was solved.
    pub doubled: Option<Vec<BodyPeaks>>,
}

impl ElasticPeaks {
    fn of(scene: &Scene, state: &State, doubled: Option<&State>) -> Self {
        Self {
            own: peaks_in(scene, state),
            doubled: doubled.map(|state| peaks_in(scene, state)),
        }
    }
}

/// The elastic solution of a case on a mesh of its own.
#[derive(Debug, Clone)]
pub struct Twin {
    pub(super) peaks: ElasticPeaks,
    pub(super) claims: Vec<Figure>,
    pub(super) told: ElasticTwin,
}

impl Twin {
    /// Of an elastic case that is solved, with the name of the folder of its files.
    pub fn of(outcome: &Outcome, folder: String) -> Self {
        Self {
            peaks: ElasticPeaks::of(&outcome.scene, outcome.state(), None),
            claims: outcome.summary.answer.certificate.clone(),
            told: ElasticTwin {
                folder,
                dofs: outcome.summary.counters.dofs,
            },
        }
    }
}

/// Tells nothing, but stops where the observer behind it wants to.
struct Stoppable<'o>(&'o dyn Observer);

impl Observer for Stoppable<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
