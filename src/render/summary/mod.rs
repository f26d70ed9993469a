//! Everything that is printed of a run, as plain data: `summary.json` and the table are made
//! from it.

mod body;
mod checks;
mod inputs;
mod interface;
mod load_line;
mod sizing;
mod steps;
mod unloaded;
mod values;

pub use body::{BodySummary, RollerSummary};
pub use checks::{BalanceSummary, Checks};
pub use inputs::{Measure, SummaryInputs};
pub use interface::{InterfaceSummary, LineLoadSummary, LineSummary};
pub use load_line::LoadPoint;
pub use sizing::{Demand, EvenLoad, SizedLine, Sizing, SizingRule};
pub use steps::{StepInterface, StepSummary};
pub use unloaded::{DentSummary, Unloaded};
pub use values::{Comparison, Counters, Figure, Named, Three, Timing};

use super::left_out::LeftOut;
use super::units::UnitLabels;
use super::warnings::{Warning, warnings};
use crate::answer::certify::{Claim, Evidence, certify};
use crate::answer::results::bore::{BoreStress, bore_stress};
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::{Interface, interfaces};
use crate::answer::results::load;
use crate::answer::results::peaks::peaks;
use crate::answer::results::strain::largest_strain;
use crate::ground::file::{FileError, write_atomically};
use crate::model::state::Energy;
use crate::render::OutputError;
use body::bodies;
use checks::{balance, checks};
use interface::interface_summary;
use serde::Serialize;
use std::path::Path;

/// Everything that is said of a run. What is missing is null in JSON, never "not a number".
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    pub case: String,
    pub units: UnitLabels,
    pub brinell_version: String,
    pub converged: bool,
    /// Name of the step whose end the figures are of, and share of it that is done: the last one, or,
    /// where the last steps unload, the one before them.
    pub step: String,
    pub step_done: f64,
    /// The ends of all steps that are done.
    pub steps: Vec<StepSummary>,
    pub dofs: usize,
    pub elements: usize,
    pub iterations: usize,
    pub factorisations: usize,
    pub krylov_directions: usize,
    pub kept_dofs: usize,
    pub factor_entries: usize,
    pub timing: Timing,
    pub peak_memory_bytes: Option<u64>,
    /// The load that acts at that moment, as a vector, and its size.
    pub applied_force: [f64; 3],
    pub applied_load: f64,
    pub descent: Option<f64>,
    /// Largest principal strain by size.
    pub max_strain: Option<f64>,
    pub bodies: Named<BodySummary>,
    pub interfaces: Named<InterfaceSummary>,
    pub rollers: Named<RollerSummary>,
    /// Bodies that nothing but contact holds.
    pub balance: Named<BalanceSummary>,
    /// Load over descent.
    pub stiffness: Option<f64>,
    /// Load and descent at the end of each step.
    pub load_line: Vec<LoadPoint>,
    pub unloaded: Option<Unloaded>,
    /// Where the work of the loads went; null where a support is displaced.
    pub energy: Option<Energy>,
    pub checks: Checks,
    /// What the figures are worth.
    pub certificate: Vec<Claim>,
    pub comparison: Vec<Comparison>,
    /// The sizing rules, for bearings.
    pub sizing: Option<Sizing>,
    pub assumptions: Vec<String>,
    pub left_out: Vec<LeftOut>,
    pub warnings: Vec<Warning>,
}

impl Summary {
    /// Gathers the summary.
    ///
    /// # Errors
    /// [`OutputError::Misfit`] where the state is not one of the scene.
    pub fn new(inputs: &SummaryInputs) -> Result<Self, OutputError> {
        let (scene, state) = (inputs.scene, inputs.state);
        state.check(scene)?;
        inputs.unloaded.map_or(Ok(()), |state| state.check(scene))?;
        inputs.steps.iter().try_for_each(|step| step.check(scene))?;
        let measured = interfaces(scene, state);
        let peaks = peaks(scene, state, inputs.recovered);
        let applied_load = load::applied(scene, state);
        let descent = load::descent(scene, state);
        let strain = largest_strain(&scene.mesh, &state.displacement).map(|(value, _)| value);
        let bores = inputs.bores.iter().map(|bore| {
            let stress = bore_stress(scene, state, inputs.recovered, bore);
            (bore.body.clone(), stress.unwrap_or_default())
        });
        let bores: Vec<(String, BoreStress)> = bores.collect();
        let rollers = bores
            .iter()
            .map(|(body, stress)| (body.clone(), stress.into()));
        let edges = LoadedEdges::find(scene, state);
        let line = |pair| HeaviestLine::find(scene, state, pair, &edges);
        let lines: Vec<Option<HeaviestLine>> = (0..measured.len()).map(line).collect();
        let interface = |(pair, measured): (usize, &Interface)| {
            let heaviest = lines[pair].as_ref();
            (
                measured.name.clone(),
                interface_summary(inputs, pair, (measured, heaviest)),
            )
        };
        let unloaded = (inputs.unloaded).map(|state| Unloaded::new(scene, state, inputs.stays));
        let dents: Vec<_> = (unloaded.iter().flat_map(|unloaded| &unloaded.dents.0))
            .map(|(surface, dent)| (surface.clone(), dent.body.clone(), dent.depth))
            .collect();
        let mut summary = Self {
            case: inputs.case.to_string(),
            units: inputs.units.clone(),
            brinell_version: env!("CARGO_PKG_VERSION").to_string(),
            converged: inputs.converged,
            step: scene
                .steps
                .get(state.step)
                .map_or_else(String::new, |s| s.name.clone()),
            step_done: state.time,
            steps: steps::steps(inputs),
            dofs: inputs.counters.dofs,
            elements: scene.mesh.hexes.len(),
            iterations: inputs.counters.iterations,
            factorisations: inputs.counters.factorisations,
            krylov_directions: inputs.counters.krylov_directions,
            kept_dofs: inputs.counters.kept_dofs,
            factor_entries: inputs.counters.factor_entries,
            timing: inputs.timing.clone(),
            peak_memory_bytes: inputs.peak_memory_bytes,
            applied_force: load::resultant(scene, state),
            applied_load,
            descent,
            max_strain: strain,
            bodies: bodies(inputs, &peaks),
            interfaces: Named(measured.iter().enumerate().map(interface).collect()),
            rollers: Named(rollers.collect()),
            balance: balance(scene, state),
            stiffness: descent.filter(|d| *d != 0.0).map(|d| applied_load / d),
            load_line: load_line::points(scene, inputs.steps),
            unloaded,
            energy: state.energy.map(|e| e.times(load::copies(scene))),
            checks: checks(inputs, &measured, applied_load, descent),
            certificate: certify(&Evidence {
                scene,
                state,
                recovered: inputs.recovered,
                peaks: &peaks,
                interfaces: &measured,
                lines: &lines,
                edges: &edges,
                bores: &bores,
                dents: &dents,
                elastic: inputs.elastic,
                doubled: inputs.doubled,
            }),
            comparison: inputs.comparison.to_vec(),
            sizing: None,
            assumptions: inputs.assumptions.to_vec(),
            left_out: inputs.left_out.to_vec(),
            warnings: Vec::new(),
        };
        summary.warnings = warnings(&summary);
        Ok(summary)
    }

    /// Writes `summary.json`, indented, atomically.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_atomically(path, |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            writeln!(out)
        })
    }
}
