//! Everything that is printed of a run, as plain data: `summary.json` and the table are made
//! from it.

use std::path::Path;

use serde::{Serialize, Serializer};

use super::file::{OutputError, write_atomically};
use super::left_out::LeftOut;
use super::units::UnitLabels;
use super::warnings::{Warning, warnings};
use crate::results::State;
use crate::results::bore::{Bore, bore_stress};
use crate::results::edges::{LoadedEdges, carrier};
use crate::results::interface::{Interface, StatusCounts, interfaces};
use crate::results::line_load::{LineLoad, Slices, line_load};
use crate::results::load;
use crate::results::peaks::{BodyPeaks, Peak, peaks};
use crate::results::recovery::Recovered;
use crate::results::strain::largest_strain;
use crate::results::strip::{Strip, half_width};
use crate::scene::Scene;

/// What a summary is made from. Figures are in the units of the scene, which `units` names.
#[derive(Debug, Clone)]
pub struct SummaryInputs<'a> {
    pub case: &'a str,
    pub units: UnitLabels,
    pub scene: &'a Scene,
    /// The state to report, commonly the one at full load.
    pub state: &'a State,
    pub recovered: &'a Recovered,
    /// Peaks of the elastic solution at the same load, in the order of the bodies.
    pub elastic: Option<&'a [BodyPeaks]>,
    pub converged: bool,
    pub counters: Counters,
    pub timing: Timing,
    pub peak_memory_bytes: Option<u64>,
    /// What to measure at each interface, in the order of the pairs; line load in ten equal
    /// slices where the list is shorter.
    pub measures: &'a [Measure],
    pub bores: &'a [Bore],
    /// Checks made elsewhere; a force balance, penetration or Coulomb violation that is left out
    /// is computed here.
    pub checks: Checks,
    pub comparison: &'a [Comparison],
    pub assumptions: &'a [String],
    pub left_out: &'a [LeftOut],
}

/// What to measure at an interface beyond its scalars.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Measure {
    /// Slices of the line load.
    pub slices: Option<Slices>,
    /// The strip whose half-width is wanted.
    pub strip: Option<Strip>,
}

/// Counts of the solver.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counters {
    pub dofs: usize,
    pub iterations: usize,
    pub factorisations: usize,
    /// Directions of the Krylov method, each a product with the matrix and a solution with a factor.
    pub krylov_directions: usize,
    /// Unknowns that the Newton iterations see, the others being eliminated beforehand.
    pub kept_dofs: usize,
    /// Entries of the factors that are held at the end.
    pub factor_entries: usize,
}

/// Seconds on the clock; those with `cpu` in their names are of all threads of the process together.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Timing {
    /// Reading or making the mesh, and the scene from it.
    pub mesh_s: f64,
    pub solve_s: f64,
    /// Not known on every system.
    pub solve_cpu_s: Option<f64>,
    /// Fields of the increments to their files, with recovering them.
    pub write_s: f64,
    /// Solving once more without plasticity.
    pub elastic_s: f64,
    pub total_s: f64,
    /// What `solve_s` went into.
    pub phases: Named<f64>,
}

/// Relative figures that say how well the answer satisfies its own equations.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Checks {
    /// Largest difference between the load and the force of an interface, relative to the load.
    /// Right for bodies in series; pass another where they are not.
    pub force_balance: Option<f64>,
    /// Largest penetration relative to the descent.
    pub max_penetration_relative: Option<f64>,
    /// Largest tangential traction beyond μ p, relative to μ times the largest pressure.
    pub coulomb_violation: Option<f64>,
    /// Share of the load that stabilisation carries.
    pub stabilisation_share: Option<f64>,
}

/// A figure of a reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Figure {
    Value(f64),
    /// Smallest and largest.
    Range([f64; 2]),
}

/// A figure of this run beside those of others.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Comparison {
    /// The quantity with its unit and measure, such as "Mises, centroid, ksi".
    pub what: String,
    /// Where in the bearing.
    #[serde(rename = "where")]
    pub place: String,
    /// What the reference study prints.
    pub report: Option<Figure>,
    /// The same quantity on the report-like mesh.
    pub report_like: Option<f64>,
    /// This run.
    pub value: Option<f64>,
    /// Estimated error of `value`, in its unit.
    pub error: Option<f64>,
    /// Hertz's figure for the same load.
    pub hertz: Option<f64>,
}

/// One value for each of the three ways to read a Mises peak.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Three<T> {
    pub centroid: T,
    pub integration_point: T,
    pub nodal: T,
}

impl<T: Copy> Three<T> {
    /// The three in the order of their printing.
    pub fn each(&self) -> [T; 3] {
        [self.centroid, self.integration_point, self.nodal]
    }
}

/// Named values in the order of the scene; an object in JSON.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Named<T>(pub Vec<(String, T)>);

impl<T: Serialize> Serialize for Named<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<T> Named<T> {
    /// The value called `name`.
    pub fn get(&self, name: &str) -> Option<&T> {
        self.0
            .iter()
            .find(|(n, _)| n == name)
            .map(|(_, value)| value)
    }
}

/// A body in the summary.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct BodySummary {
    pub mises_max: Three<Option<f64>>,
    /// Undeformed coordinates of the three peaks.
    pub at: Three<Option<[f64; 3]>>,
    /// Peaks beside a loaded edge, which grow with every refinement.
    pub at_singular_edge: Three<bool>,
    /// Peaks of the elastic solution, where the body has yielded and that solution is known.
    pub elastic_mises_max: Option<Three<Option<f64>>>,
    pub peeq_max: f64,
    /// In the whole body, not only its modelled part; so is `volume`.
    pub yielded_volume: f64,
    pub volume: f64,
}

/// Line load of an interface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineLoadSummary {
    /// The axis along the carrier body: x, y or z.
    pub axis: &'static str,
    /// Ends of the slices.
    pub edges: Vec<f64>,
    /// Mean force per length of each slice.
    pub values: Vec<f64>,
    /// Each slice stands for two: twice the sum over slices is the load.
    pub mirrored: bool,
    /// Force outside the slices.
    pub outside: f64,
}

/// An interface in the summary; forces and areas are those of the whole bearing.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct InterfaceSummary {
    pub force: [f64; 3],
    pub normal_force: f64,
    pub pressure_integral: f64,
    pub max_pressure: f64,
    pub max_pressure_at: Option<[f64; 3]>,
    pub max_penetration: f64,
    /// Penetration relative to the shortest side of a face that carries pressure.
    pub penetration_per_element: Option<f64>,
    pub area: f64,
    pub half_width: Option<f64>,
    /// Not measured without friction.
    pub max_slip: Option<f64>,
    pub status_counts: StatusCounts,
    pub q: Option<LineLoadSummary>,
}

/// A hollow roller in the summary.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct RollerSummary {
    pub bore_mises: Option<f64>,
    pub bore_mises_at: Option<[f64; 3]>,
    pub bore_mises_nodal: Option<f64>,
    pub bore_mises_nodal_at: Option<[f64; 3]>,
}

/// Everything that is said of a run. What is missing is null in JSON, never "not a number".
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    pub case: String,
    pub units: UnitLabels,
    pub brinell_version: String,
    pub converged: bool,
    /// Name of the step and share of it that is done.
    pub step: String,
    pub step_done: f64,
    pub dofs: usize,
    pub elements: usize,
    pub iterations: usize,
    pub factorisations: usize,
    pub krylov_directions: usize,
    pub kept_dofs: usize,
    pub factor_entries: usize,
    pub timing: Timing,
    pub peak_memory_bytes: Option<u64>,
    pub applied_load: f64,
    pub descent: Option<f64>,
    /// Largest principal strain by size.
    pub max_strain: Option<f64>,
    pub bodies: Named<BodySummary>,
    pub interfaces: Named<InterfaceSummary>,
    pub rollers: Named<RollerSummary>,
    pub checks: Checks,
    pub comparison: Vec<Comparison>,
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
        let measured = interfaces(scene, state);
        let applied_load = load::applied(scene, state);
        let descent = load::descent(scene, state);
        let strain = largest_strain(&scene.mesh, &state.displacement).map(|(value, _)| value);
        let bores = inputs
            .bores
            .iter()
            .map(|bore| (bore.body.clone(), roller(inputs, bore)));
        let interface = |(pair, measured): (usize, &Interface)| {
            (
                measured.name.clone(),
                interface_summary(inputs, pair, measured),
            )
        };
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
            dofs: inputs.counters.dofs,
            elements: scene.mesh.hexes.len(),
            iterations: inputs.counters.iterations,
            factorisations: inputs.counters.factorisations,
            krylov_directions: inputs.counters.krylov_directions,
            kept_dofs: inputs.counters.kept_dofs,
            factor_entries: inputs.counters.factor_entries,
            timing: inputs.timing.clone(),
            peak_memory_bytes: inputs.peak_memory_bytes,
            applied_load,
            descent,
            max_strain: strain,
            bodies: bodies(inputs),
            interfaces: Named(measured.iter().enumerate().map(interface).collect()),
            rollers: Named(bores.collect()),
            checks: checks(&inputs.checks, &measured, applied_load, descent),
            comparison: inputs.comparison.to_vec(),
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
    /// [`OutputError::Write`] names the path.
    pub fn write(&self, path: &Path) -> Result<(), OutputError> {
        write_atomically(path, |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            writeln!(out)
        })
    }
}

fn bodies(inputs: &SummaryInputs) -> Named<BodySummary> {
    let (scene, state) = (inputs.scene, inputs.state);
    let edges = LoadedEdges::find(scene, state);
    let summarise = |(body, peaks): (usize, &BodyPeaks)| {
        let elastic = inputs
            .elastic
            .filter(|_| peaks.peeq_max > 0.0)
            .and_then(|e| e.get(body));
        let touches = |peak: Peak| edges.touches(&scene.mesh, state, &peak);
        let summary = BodySummary {
            mises_max: three(peaks, |peak| peak.value),
            at: three(peaks, |peak| peak.at),
            at_singular_edge: Three {
                centroid: peaks.centroid.is_some_and(touches),
                integration_point: peaks.integration_point.is_some_and(touches),
                nodal: peaks.nodal.is_some_and(touches),
            },
            elastic_mises_max: elastic.map(|e| three(e, |peak| peak.value)),
            peeq_max: peaks.peeq_max,
            yielded_volume: peaks.yielded_volume,
            volume: peaks.volume,
        };
        (peaks.name.clone(), summary)
    };
    let peaks = peaks(scene, state, inputs.recovered);
    Named(peaks.iter().enumerate().map(summarise).collect())
}

fn three<T>(peaks: &BodyPeaks, read: impl Fn(Peak) -> T) -> Three<Option<T>> {
    Three {
        centroid: peaks.centroid.map(&read),
        integration_point: peaks.integration_point.map(&read),
        nodal: peaks.nodal.map(&read),
    }
}

fn roller(inputs: &SummaryInputs, bore: &Bore) -> RollerSummary {
    let stress = bore_stress(inputs.scene, inputs.state, inputs.recovered, bore);
    let stress = stress.unwrap_or_default();
    RollerSummary {
        bore_mises: stress.mises,
        bore_mises_at: stress.mises_at,
        bore_mises_nodal: stress.nodal,
        bore_mises_nodal_at: stress.nodal_at,
    }
}

fn interface_summary(
    inputs: &SummaryInputs,
    pair: usize,
    measured: &Interface,
) -> InterfaceSummary {
    let (scene, state) = (inputs.scene, inputs.state);
    let asked = inputs.measures.get(pair);
    let slices = match asked {
        Some(measure) => measure.slices.clone(),
        None => Slices::equal(scene, pair, 10),
    };
    let strip = asked.and_then(|measure| measure.strip);
    InterfaceSummary {
        force: measured.force,
        normal_force: measured.normal_force,
        pressure_integral: measured.pressure_integral,
        max_pressure: measured.max_pressure,
        max_pressure_at: measured.max_pressure_at,
        max_penetration: measured.max_penetration,
        penetration_per_element: measured
            .face_side
            .map(|side| measured.max_penetration / side),
        area: measured.area,
        half_width: strip.and_then(|strip| {
            half_width(
                &scene.mesh,
                carrier(scene, pair)?,
                &state.contacts[pair],
                &strip,
            )
        }),
        max_slip: (scene.contacts[pair].friction > 0.0).then_some(measured.max_slip),
        status_counts: measured.status_counts,
        q: slices
            .and_then(|s| line_load(scene, state, pair, &s))
            .map(LineLoadSummary::from),
    }
}

impl From<LineLoad> for LineLoadSummary {
    fn from(load: LineLoad) -> Self {
        Self {
            axis: ["x", "y", "z"]
                .get(load.slices.axis)
                .copied()
                .unwrap_or("?"),
            edges: load.slices.edges,
            values: load.q,
            mirrored: load.mirrored,
            outside: load.outside,
        }
    }
}

impl Serialize for StatusCounts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("open", self.open),
            ("stick", self.stick),
            ("slip", self.slip),
        ])
    }
}

fn checks(given: &Checks, measured: &[Interface], load: f64, descent: Option<f64>) -> Checks {
    let largest = |of: &dyn Fn(&Interface) -> f64| measured.iter().map(of).fold(0.0, f64::max);
    let relative = |value: f64, to: f64| (to != 0.0).then(|| value / to.abs());
    let some = |value: Option<f64>| value.filter(|_| !measured.is_empty());
    let penetration = || relative(largest(&|i| i.max_penetration), descent?);
    Checks {
        force_balance: given
            .force_balance
            .or_else(|| some(relative(largest(&|i| (i.normal_force - load).abs()), load))),
        max_penetration_relative: given
            .max_penetration_relative
            .or_else(|| some(penetration())),
        coulomb_violation: given
            .coulomb_violation
            .or_else(|| some(Some(largest(&|i| i.coulomb_violation)))),
        stabilisation_share: given.stabilisation_share,
    }
}
