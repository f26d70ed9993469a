//! What a solved scene says: every figure of it, computed once, with its error.
//!
//! [`Answer::of`] takes a solved scene; [`Solved`] solves one and keeps its answer. What prints, draws or compares figures reads the [`Answer`] and computes
//! nothing.

pub mod certify;
#[doc(hidden)]
pub mod pictures;
pub mod results;

mod body;
pub(crate) mod checks;
mod inputs;
mod interface;
mod load_line;
mod named;
mod patch;
mod plane;
mod solved;
mod steps;
mod tie;
mod unloaded;

pub use body::{BodyFigures, RollerFigures};
pub use checks::{BalanceFigures, Checks};
pub use inputs::AnswerInputs;
pub use interface::{InterfaceFigures, LineFigures, LineLoadFigures};
pub use load_line::LoadPoint;
pub use named::{Named, Three};
pub use patch::PatchFigures;
pub use plane::PlaneFigures;
pub use solved::Solved;
use steps::StepEnd;
pub use steps::{StepFigures, StepInterface};
pub use tie::TieFigures;
pub use unloaded::{DentFigures, Unloaded};

use crate::ground::geometry::{add, sub};
use crate::model::state::{Energy, Misfit, State};
use certify::{
    Contacts, Earlier, Evidence, Figure, Outside, Quantity, Travel, certify, figure, unresolved,
};
use results::bore::{BoreStress, bore_stress};
use results::edges::SingularEdges;
use results::hertz::HeaviestLine;
use results::interface::interfaces;
use results::load;
use results::peaks::peaks;
use results::recovery::recover;
use results::strain::largest_strain;
use serde::Serialize;

/// Every figure of a solved scene. What is missing is null in JSON, never "not a number".
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Answer {
    /// Did the solution reach the end of the last step?
    pub converged: bool,
    /// Was the run stopped on demand before that? `--resume` goes on with it.
    pub interrupted: bool,
    /// Name of the step whose end the figures are of, and share of it that is done: the last one, or,
    /// where the last steps unload, the one before them.
    pub step: String,
    /// Share of that step that is done, in (0, 1].
    pub step_done: f64,
    /// The ends of all steps that are done.
    pub steps: Vec<StepFigures>,
    /// Was steel that has a yield stress let yield?
    pub plasticity: bool,
    /// Hexahedra of the mesh.
    pub elements: usize,
    /// The load that acts at that moment, as a vector, and its size.
    pub applied_force: [f64; 3],
    /// The size of that load.
    pub applied_load: f64,
    /// Travel of what is loaded, along the load, with what the mesh is likely to miss of it.
    pub descent: Option<f64>,
    /// That of its nodes.
    pub descent_of_mesh: Option<f64>,
    /// Largest principal strain by size.
    pub max_strain: Option<f64>,
    /// Every body, in the order of the mesh.
    pub bodies: Named<BodyFigures>,
    /// Every contact pair, in the order of the scene.
    pub interfaces: Named<InterfaceFigures>,
    /// Every tie, in the order of the scene; left out of JSON where there is none.
    #[serde(skip_serializing_if = "Named::is_empty")]
    pub ties: Named<TieFigures>,
    /// Every hollow roller.
    pub rollers: Named<RollerFigures>,
    /// Bodies that nothing but contact holds.
    pub balance: Named<BalanceFigures>,
    /// Load over descent.
    pub stiffness: Option<f64>,
    /// Load and descent at the end of each step.
    pub load_line: Vec<LoadPoint>,
    /// What is left where the load has been taken off.
    pub unloaded: Option<Unloaded>,
    /// Where the work of the loads went; null where a support is displaced.
    pub energy: Option<Energy>,
    /// How well the answer satisfies its own equations.
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
        let scene = solved.scene;
        let more = solved.unloaded.into_iter().chain(solved.steps);
        let more = more.chain(solved.doubled);
        let mut states = [solved.state].into_iter().chain(more);
        states.try_for_each(|state| state.check(scene))?;
        Ok(Self::gather(solved))
    }

    /// The same where the states are known to be those of the scene.
    fn gather(solved: &AnswerInputs) -> Self {
        let (scene, state) = (solved.scene, solved.state);
        let edges = SingularEdges::find(scene, state);
        let measured = interfaces(scene, state);
        let lines = HeaviestLine::of_pairs(scene, state, &edges.loaded);
        let peaks = peaks((scene, state), solved.recovered, &edges, &lines);
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
        let contacts = Contacts {
            interfaces: &measured,
            lines: &lines,
        };
        let outside = Outside::of(scene);
        let seen = (contacts, &outside, &edges);
        let travel = Travel::of(scene, state, solved.recovered, seen);
        let ends = steps::steps(solved, &outside, (&peaks, travel));
        let is_earlier = |(other, _): &(&State, &StepEnd)| other.step < state.step;
        let earlier = solved.steps.iter().zip(&ends).filter(is_earlier);
        let earlier: Vec<Earlier> = earlier.map(|(_, end)| end.as_earlier()).collect();
        let travel = travel.map(|travel| travel.after(earlier.iter().filter_map(|end| end.travel)));
        let doubled = doubled(solved);
        let certificate = certify(&Evidence {
            scene,
            state,
            outside: &outside,
            recovered: solved.recovered,
            earlier: &earlier,
            travel,
            peaks: &peaks,
            interfaces: &measured,
            lines: &lines,
            edges: &edges,
            bores: &bores,
            dents: &dents,
            elastic: solved.elastic,
            elastic_claims: solved.elastic_claims,
            doubled: doubled.as_deref(),
        });
        let load = load::applied(scene, state);
        let descent = travel.map(|travel| travel.value());
        let step = scene.steps.get(state.step);
        let steps: Vec<StepFigures> = ends.into_iter().map(|end| end.figures).collect();
        let rollers = bores
            .iter()
            .map(|(body, stress)| (body.clone(), stress.into()));
        let strain = largest_strain(&scene.mesh, &state.displacement);
        Self {
            converged: solved.converged,
            interrupted: solved.interrupted,
            step: step.map_or_else(String::new, |step| step.name.clone()),
            step_done: state.time,
            load_line: load_line::points(&steps),
            steps,
            plasticity: scene.may_yield(),
            elements: scene.mesh.hexes.len(),
            applied_force: load::resultant(scene, state),
            applied_load: load,
            descent,
            descent_of_mesh: travel.map(|travel| travel.of_mesh),
            max_strain: strain.map(|(value, _)| value),
            bodies: body::bodies(solved, &peaks, &edges),
            interfaces: interface::all(solved, &measured, &lines),
            ties: tie::ties(scene, state),
            rollers: Named(rollers.collect()),
            balance: checks::balance(scene, state),
            // Warm bodies, and what tips, go another way than the load pushes.
            stiffness: descent
                .filter(|d| *d * load > 0.0 && scene.temperatures.is_empty())
                .map(|d| load / d),
            unloaded,
            energy: state.energy.map(|e| e.times(load::copies(scene))),
            checks: checks::checks(solved, &measured, load),
            certificate,
        }
    }

    /// The figure `what` of a body, an interface or "overall", with its error.
    pub fn figure(&self, what: Quantity, place: &str) -> Option<&Figure> {
        figure(&self.certificate, what, place)
    }

    /// What the yield stress of a body is asked about: the elastic peak where it has yielded and that is known, away from
    /// loaded edges where the peak lies at one. Flow only lowers a peak while loads grow; where the body bears more than that after other
    /// steps, it is left from larger loads before, and counts.
    pub fn elastic_mises(&self, body: &str) -> Option<&Figure> {
        let of = |what| self.figure(what, body);
        let later = self.steps.iter().position(|step| step.reported) > Some(0);
        // A peak at a loaded edge is a figure of the mesh.
        let (elastic, borne) = match of(Quantity::ElasticMisesAway) {
            Some(away) => (Some(away), of(Quantity::MisesAway)),
            None => (of(Quantity::ElasticPeakMises), of(Quantity::PeakMises)),
        };
        match (elastic, borne) {
            (Some(elastic), Some(borne)) if later && borne.value > elastic.value => Some(borne),
            (Some(elastic), _) => Some(elastic),
            (None, _) => of(Quantity::MisesAway).or(borne),
        }
    }

    /// Share that Hertz's pressure of the lines of an interface may be off by: as the certificate has it, or, where it has
    /// none, half of the share of the line load, with whose root it goes.
    pub fn hertz_pressure_bar(&self, interface: &str) -> Option<f64> {
        let share = |what| self.figure(what, interface)?.relative_bar();
        let of_load = || Some(0.5 * share(Quantity::LineLoad)?);
        share(Quantity::HertzPressure).or_else(of_load)
    }

    /// The figures that stand for themselves, and those in whose place others stand: see [`certify::is_replaced`].
    pub fn standing(&self) -> (Vec<&Figure>, Vec<&Figure>) {
        let claims = &self.certificate;
        claims
            .iter()
            .partition(|claim| !certify::is_replaced(claims, claim))
    }

    /// The figures of which nothing can be said, and that nothing is said in place of.
    pub fn unresolved(&self) -> Vec<&Figure> {
        unresolved(&self.certificate)
    }
}

/// What is said of the solution in increments twice as large, where there is one.
fn doubled(solved: &AnswerInputs) -> Option<Vec<Figure>> {
    let at = |step| solved.doubled.iter().find(|state| state.step == step);
    let state = at(solved.state.step)?;
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
        elastic: solved.elastic_doubled,
        doubled: &[],
        ..*solved
    };
    Some(Answer::gather(&other).certificate)
}
