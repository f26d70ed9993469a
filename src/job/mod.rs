//! One case from its file to its results on disk: mesh, solve, write, summarise.

mod compare;
mod error;
mod left_out;
mod mesh;
mod record;

use crate::case::{Case, Kind};
use crate::output::summary::{Checks, Counters, Timing};
use crate::output::{Summary, SummaryInputs, UnitLabels};
use crate::results::State;
use crate::results::bore::Bore;
use crate::results::peaks::{BodyPeaks, peaks};
use crate::results::recovery::recover;
use crate::scene::Scene;
use crate::solve::{self, Observer, Silent, Solution};
pub use error::JobError;
pub use mesh::{find_mesh, make_mesh};
use record::Recorder;
use std::path::PathBuf;
use std::time::Instant;

/// Where a job writes and what it may leave out.
#[derive(Debug, Clone)]
pub struct Options {
    /// Folder of the VTK files and `summary.json`; `None` writes nothing.
    pub out: Option<PathBuf>,
    /// Solve once more without plasticity where a body has yielded, for the elastic peaks.
    pub elastic_peaks: bool,
}

/// A finished job.
#[derive(Debug)]
pub struct Outcome {
    /// The scene as solved, its bodies in touch.
    pub scene: Scene,
    pub solution: Solution,
    /// At full load: the end of the first step.
    pub summary: Summary,
}

impl Outcome {
    /// The state that the summary describes.
    pub fn state(&self) -> &State {
        reported(&self.solution)
    }
}

/// The end of the first step, where the full load is on.
fn reported(solution: &Solution) -> &State {
    solution.states.first().unwrap_or(&solution.last)
}

/// Runs `case` on its mesh, telling `observer` of every iteration.
///
/// # Errors
/// [`JobError`]; increments accepted before an error are on disk.
pub fn run(
    case: &Case,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    let start = Instant::now();
    if let Some(out) = &options.out {
        std::fs::create_dir_all(out).map_err(|error| JobError::folder(out, error))?;
    }
    let mesh = find_mesh(case, options.out.as_deref(), &mut |line| {
        observer.message(line)
    })?;
    let mut scene = case.scene(mesh)?;
    let mesh_s = start.elapsed().as_secs_f64();
    observer.message(&format!(
        "{} nodes, {} hexahedra, {} bodies",
        scene.mesh.points.len(),
        scene.mesh.hexes.len(),
        scene.mesh.bodies.len()
    ));
    let solving = Instant::now();
    let mut recorder = Recorder::new(case, options.out.as_deref(), scene.clone(), observer);
    let solution = solve::solve(&mut scene, &mut recorder)?;
    let solve_s = solving.elapsed().as_secs_f64() - recorder.seconds();
    let elastic = match options.elastic_peaks {
        true => elastic_peaks(&scene, &solution, observer)?,
        false => None,
    };
    let timing = Timing {
        mesh_s,
        solve_s,
        total_s: start.elapsed().as_secs_f64(),
    };
    let summary = summarise(case, &scene, &solution, elastic.as_deref(), timing)?;
    if let Some(out) = &options.out {
        summary.write(&out.join("summary.json"))?;
    }
    Ok(Outcome {
        scene,
        solution,
        summary,
    })
}

/// Peaks of the same scene without plasticity, where it has yielded.
fn elastic_peaks(
    scene: &Scene,
    solution: &Solution,
    observer: &mut dyn Observer,
) -> Result<Option<Vec<BodyPeaks>>, JobError> {
    let yielded = reported(solution).peeq.iter().flatten().any(|p| *p > 0.0);
    if !yielded || !solution.complete {
        return Ok(None);
    }
    observer
        .message("something yielded: solving once more without plasticity, for the elastic peaks");
    let mut elastic = scene.clone();
    elastic.controls.plasticity = false;
    elastic.steps.truncate(1);
    let solution = solve::solve(&mut elastic, &mut Silent)?;
    let state = reported(&solution);
    let recovered = recover(&elastic.mesh, state);
    Ok(Some(peaks(&elastic, state, &recovered)))
}

fn summarise(
    case: &Case,
    scene: &Scene,
    solution: &Solution,
    elastic: Option<&[BodyPeaks]>,
    timing: Timing,
) -> Result<Summary, JobError> {
    let state = reported(solution);
    let recovered = recover(&scene.mesh, state);
    let units = case.units;
    let mut inputs = SummaryInputs {
        case: &case.title,
        units: UnitLabels::new(units.length(), units.force(), units.stress()),
        scene,
        state,
        recovered: &recovered,
        elastic,
        converged: solution.complete,
        counters: Counters {
            dofs: solution.counters.equations,
            iterations: solution.counters.iterations,
            factorisations: solution.counters.factorisations,
        },
        timing,
        peak_memory_bytes: peak_memory(),
        measures: &[],
        bores: &bores(case),
        // Nothing but bodies and contact carries force: the tangent alone is shifted.
        checks: Checks {
            stabilisation_share: Some(0.0),
            ..Checks::default()
        },
        comparison: &[],
        assumptions: &assumptions(case),
        left_out: &left_out::list(case, scene, solution),
    };
    let bare = Summary::new(&inputs)?;
    let comparison = compare::rows(case, scene, &bare)?;
    inputs.comparison = &comparison;
    Ok(Summary {
        comparison: comparison.clone(),
        ..bare
    })
}

/// Inner walls of hollow rollers.
fn bores(case: &Case) -> Vec<Bore> {
    match &case.kind {
        Kind::Bearing(bearing) if bearing.geometry.wall.is_some() => {
            ["upper_roller", "lower_roller"]
                .into_iter()
                .zip([1, 0])
                .map(|(body, axis)| Bore {
                    body: body.to_owned(),
                    surface: format!("{body}_bore"),
                    axis,
                })
                .collect()
        }
        _ => Vec::new(),
    }
}

fn assumptions(case: &Case) -> Vec<String> {
    let taken = case
        .assumptions
        .iter()
        .map(|a| format!("{} = {}: {}", a.key, a.value, a.why));
    let found = case
        .discrepancies
        .iter()
        .map(|d| format!("{}: {}", d.what, d.effect));
    taken.chain(found).collect()
}

/// Largest memory of this process so far, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kib)
}
