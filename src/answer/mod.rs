//! What a solved scene says: every figure of it, computed once, with its error.
//!
//! [`Answer::of`] takes a [`AnswerInputs`] scene. What prints, draws or compares figures reads the [`Answer`] and computes
//! nothing.

pub mod certify;
pub mod pictures;
pub mod results;

mod body;
mod checks;
mod inputs;
mod interface;
mod load_line;
mod named;
mod steps;
mod unloaded;

pub use body::{BodyFigures, RollerFigures};
pub use checks::{BalanceFigures, Checks};
pub use inputs::{AnswerInputs, Measured};
pub use interface::{InterfaceFigures, LineFigures, LineLoadFigures};
pub use load_line::LoadPoint;
pub use named::{Named, Three};
pub use steps::{StepFigures, StepInterface};
pub use unloaded::{DentFigures, Unloaded};

use crate::ground::geometry::{add, sub};
use crate::model::state::{Energy, Misfit};
use certify::{Evidence, Figure, Quantity, certify, figure};
use results::bore::{BoreStress, bore_stress};
use results::edges::LoadedEdges;
use results::hertz::HeaviestLine;
use results::interface::interfaces;
use results::load;
use results::peaks::peaks;
use results::recovery::recover;
use results::strain::largest_strain;
use serde::Serialize;

/// Every figure of a solved scene. What is missing is null in JSON, never "not a number".
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    pub converged: bool,
    /// Name of the step whose end the figures are of, and share of it that is done: the last one, or,
    /// where the last steps unload, the one before them.
    pub step: String,
    pub step_done: f64,
    /// The ends of all steps that are done.
    pub steps: Vec<StepFigures>,
    pub elements: usize,
    /// The load that acts at that moment, as a vector, and its size.
    pub applied_force: [f64; 3],
    pub applied_load: f64,
    pub descent: Option<f64>,
    /// Largest principal strain by size.
    pub max_strain: Option<f64>,
    pub bodies: Named<BodyFigures>,
    pub interfaces: Named<InterfaceFigures>,
    pub rollers: Named<RollerFigures>,
    /// Bodies that nothing but contact holds.
    pub balance: Named<BalanceFigures>,
    /// Load over descent.
    pub stiffness: Option<f64>,
    /// Load and descent at the end of each step.
    pub load_line: Vec<LoadPoint>,
    pub unloaded: Option<Unloaded>,
    /// Where the work of the loads went; null where a support is displaced.
    pub energy: Option<Energy>,
    pub checks: Checks,
    /// What the figures are worth.
    pub certificate: Vec<Figure>,
}

impl Answer {
    /// Every figure of `solved`.
    ///
    /// # Errors
    /// [`Misfit`] where a state is not one of the scene.
    pub fn of(solved: &AnswerInputs) -> Result<Self, Misfit> {
        let (scene, state) = (solved.scene, solved.state);
        state.check(scene)?;
        solved.unloaded.map_or(Ok(()), |state| state.check(scene))?;
        solved.steps.iter().try_for_each(|step| step.check(scene))?;
        let edges = LoadedEdges::find(scene, state);
        let peaks = peaks(scene, state, solved.recovered, &edges);
        let measured = interfaces(scene, state);
        let line = |pair| HeaviestLine::find(scene, state, pair, &edges);
        let lines: Vec<Option<HeaviestLine>> = (0..measured.len()).map(line).collect();
        let bores: Vec<(String, BoreStress)> = (solved.bores.iter())
            .map(|bore| {
                let stress = bore_stress(scene, state, solved.recovered, bore);
                (bore.body.clone(), stress.unwrap_or_default())
            })
            .collect();
        let unloaded = (solved.unloaded).map(|state| Unloaded::new(scene, state, solved.stays));
        let dents: Vec<_> = (unloaded.iter().flat_map(|unloaded| &unloaded.dents.0))
            .map(|(surface, dent)| (surface.clone(), dent.body.clone(), dent.depth))
            .collect();
        let doubled = doubled(solved)?;
        let certificate = certify(&Evidence {
            scene,
            state,
            recovered: solved.recovered,
            peaks: &peaks,
            interfaces: &measured,
            lines: &lines,
            edges: &edges,
            bores: &bores,
            dents: &dents,
            elastic: solved.elastic,
            doubled: doubled.as_deref(),
        });
        let load = load::applied(scene, state);
        let descent = load::descent(scene, state);
        let step = scene.steps.get(state.step);
        let rollers = bores
            .iter()
            .map(|(body, stress)| (body.clone(), stress.into()));
        let strain = largest_strain(&scene.mesh, &state.displacement);
        Ok(Self {
            converged: solved.converged,
            step: step.map_or_else(String::new, |step| step.name.clone()),
            step_done: state.time,
            steps: steps::steps(solved, &peaks),
            elements: scene.mesh.hexes.len(),
            applied_force: load::resultant(scene, state),
            applied_load: load,
            descent,
            max_strain: strain.map(|(value, _)| value),
            bodies: body::bodies(solved, &peaks, &edges),
            interfaces: interface::all(solved, &measured, &lines),
            rollers: Named(rollers.collect()),
            balance: checks::balance(scene, state),
            stiffness: descent.filter(|d| *d != 0.0).map(|d| load / d),
            load_line: load_line::points(scene, solved.steps),
            unloaded,
            energy: state.energy.map(|e| e.times(load::copies(scene))),
            checks: checks::checks(solved, &measured, load, descent),
            certificate,
        })
    }

    /// The figure `what` of a body, an interface or "overall", with its error.
    pub fn figure(&self, what: Quantity, place: &str) -> Option<&Figure> {
        figure(&self.certificate, what, place)
    }
}

/// What is said of the solution in increments twice as large, where there is one.
fn doubled(solved: &AnswerInputs) -> Result<Option<Vec<Figure>>, Misfit> {
    let at = |step| solved.doubled.iter().find(|state| state.step == step);
    let Some(state) = at(solved.state.step) else {
        return Ok(None);
    };
    let recovered = recover(solved.scene, state);
    let unloaded = solved.unloaded.and_then(|state| at(state.step));
    let stays = solved.unloaded.zip(unloaded).and_then(|(one, other)| {
        // What is left of the load presses either solution alike.
        let moved = |(one, other): (&[f64; 3], &[f64; 3])| sub(*other, *one);
        let by = one.displacement.iter().zip(&other.displacement).map(moved);
        let stays = solved.stays?.iter().zip(by);
        Some(stays.map(|(stays, by)| add(*stays, by)).collect::<Vec<_>>())
    });
    let other = AnswerInputs {
        state,
        recovered: &recovered,
        unloaded,
        stays: stays.as_deref(),
        steps: &[],
        doubled: &[],
        ..*solved
    };
    Answer::of(&other).map(|answer| Some(answer.certificate))
}
