//! What an answer is made from.

use crate::answer::certify::Figure;
use crate::answer::results::bore::Bore;
use crate::answer::results::peaks::BodyPeaks;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::State;

/// A solved scene, as far as an answer needs it.
#[derive(Debug, Clone, Copy)]
pub struct AnswerInputs<'a> {
    /// The scene as solved, its bodies in touch.
    pub scene: &'a Scene,
    /// The state to report: the end of the last step, or of the last before unloading.
    pub state: &'a State,
    /// The fields recovered from it.
    pub recovered: &'a Recovered,
    /// The state after unloading, where there is one.
    pub unloaded: Option<&'a State>,
    /// Displacement of every node that stays when what is left of the load is taken off
    /// elastically; without it dents have the pressing of that load in them.
    pub stays: Option<&'a [[f64; 3]]>,
    /// The states at the ends of the steps, as far as they are done.
    pub steps: &'a [State],
    /// Peaks of the elastic solution at the same load, in the order of the bodies.
    pub elastic: Option<&'a [BodyPeaks]>,
    /// Those of it in increments twice as large.
    pub elastic_doubled: Option<&'a [BodyPeaks]>,
    /// The claims of that solution, where it is of another mesh; empty where it is of this one.
    pub elastic_claims: &'a [Figure],
    /// The states at the ends of the steps of the solution in increments twice as large.
    pub doubled: &'a [State],
    /// Did the solution reach the end of the last step?
    pub converged: bool,
    /// Was it stopped on demand before that?
    pub interrupted: bool,
    /// The inner walls of hollow rollers.
    pub bores: &'a [Bore],
    /// Share of the load that stabilisation carries, which only the solver knows.
    pub stabilisation_share: Option<f64>,
}

impl<'a> AnswerInputs<'a> {
    /// With nothing known but a converged state and its fields.
    pub fn new(scene: &'a Scene, state: &'a State, recovered: &'a Recovered) -> Self {
        Self {
            scene,
            state,
            recovered,
            unloaded: None,
            stays: None,
            steps: &[],
            elastic: None,
            elastic_doubled: None,
            elastic_claims: &[],
            doubled: &[],
            converged: true,
            interrupted: false,
            bores: &[],
            stabilisation_share: None,
        }
    }
}
