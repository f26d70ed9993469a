//! One case from its file to its results on disk: mesh, solve, write, summarise.

mod check;
mod checkpoint;
mod clock;
mod compare;
mod error;
mod export;
mod folder;
mod left_out;
mod limits;
mod mesh;
mod record;
mod report;
mod sizing;
mod strips;

use crate::answer::certify::Claim;
use crate::answer::results::bore::Bore;
use crate::answer::results::ending::ending;
use crate::answer::results::peaks::{BodyPeaks, peaks};
use crate::answer::results::recovery::{Recovered, recover};
use crate::case::bearing::Strips;
use crate::case::{Case, Kind};
use crate::ground::geometry::{add, sub};
use crate::ground::memory;
use crate::model::mesh::Mesh;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::model::state::turn::{FAR, largest_turn};
use crate::render::summary::{Checks, Counters, Named, Timing};
use crate::render::warnings::Warning;
use crate::render::{Summary, SummaryInputs, UnitLabels, line_load};
use crate::solver::solve::{self, Observer, Phase, Solution, Timers};
pub use check::check;
pub use checkpoint::{Checkpoint, FILE as CHECKPOINT_FILE};
use clock::Clock;
pub use error::JobError;
pub use export::{Exported, export};
use folder::Folder;
pub use mesh::{FILE as MESH_FILE, find_mesh, forecast, keep_mesh, make_mesh, unknowns};
use record::Recorder;
use std::path::{Path, PathBuf};
use std::time::Instant;
use strips::Watch;

/// Name of the summary in the folder of a run.
const SUMMARY: &str = "summary.json";

/// Where a job writes and what it may leave out.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Folder of the VTK files and `summary.json`; `None` writes nothing.
    pub out: Option<PathBuf>,
    /// Solve once more without plasticity where a body has yielded, for the elastic peaks.
    pub elastic_peaks: bool,
    /// Go on after the last increment of an earlier run of the same scene into the same folder.
    pub resume: bool,
    /// Write `report.html` beside the summary.
    pub report: bool,
}

impl Options {
    /// The folder to write into, this job's alone from now on.
    fn open(&self) -> Result<Option<Folder>, JobError> {
        let out = self.out.as_deref();
        out.map(Folder::open).transpose()
    }
}

/// A finished job.
#[derive(Debug)]
pub struct Outcome {
    /// The scene as solved, its bodies in touch.
    pub scene: Scene,
    /// States at the ends of all steps, and what they cost.
    pub solution: Solution,
    /// Of the end of the last step, or, where the last steps unload, of the step before them.
    pub summary: Summary,
    /// Was the observer's wish to stop met, before or while the elastic peaks were sought?
    pub interrupted: bool,
}

impl Outcome {
    /// Limits that the answer misses, in words.
    pub fn missed_limits(&self, case: &Case) -> Vec<String> {
        limits::missed(case, &self.summary.checks)
    }

    /// The state that the summary describes.
    pub fn state(&self) -> &State {
        reported(&self.scene, &self.solution)
    }
}

/// The state that the figures are of.
fn reported<'s>(scene: &Scene, solution: &'s Solution) -> &'s State {
    ending(scene, &solution.states, &solution.last).reported
}

/// The unloaded state, where the last steps unload.
fn unloaded<'s>(scene: &Scene, solution: &'s Solution) -> Option<&'s State> {
    ending(scene, &solution.states, &solution.last).unloaded
}

/// Is the mesh of `case` sized by its lines of contact (the preset `auto`)?
pub fn is_sized_by_lines(case: &Case) -> bool {
    strips::sized_by_lines(case).is_some()
}

/// Has an earlier run into `folder` left what [`Options::resume`] goes on from?
pub fn has_checkpoint(folder: &Path) -> bool {
    folder.join(checkpoint::FILE).is_file()
}

/// Runs `case` on its mesh, telling `observer` of every iteration. Where its mesh is sized by the
/// lines of contact and the solution finds that it does not serve them, it is meshed once more and
/// solved again.
///
/// # Errors
/// [`JobError`]; increments accepted before an error are on disk, and so is their summary.
pub fn run(
    case: &Case,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    let start = Instant::now();
    let _folder = options.open()?;
    let out = options.out.as_deref();
    let mut case = case.clone();
    let mut mesh_may_change = strips::sized_by_lines(&case).is_some();
    if let Some(out) = out.filter(|_| options.resume && mesh_may_change)
        && let Some(strips) = strips::kept(out)?
    {
        case.set_strips(strips);
        mesh_may_change = false;
    }
    loop {
        let mesh = find_mesh(&case, out, &mut |line| observer.message(line))?;
        match solve_on(&case, mesh, options, start, mesh_may_change, observer)? {
            Ended::Done(outcome) => return Ok(*outcome),
            Ended::Remesh(strips) => {
                observer.message(
                    "the lines of contact are not as wide as statics says: meshed once more, as found",
                );
                if let Some(out) = out {
                    // First gone: a checkpoint is of one mesh.
                    folder::forget(&out.join(checkpoint::FILE))?;
                    // Rows of a sweep share one file of their first mesh: no writing into that.
                    folder::forget(&out.join(MESH_FILE))?;
                    strips::keep(&strips, out)?;
                }
                case.set_strips(strips);
                mesh_may_change = false;
            }
        }
    }
}

/// Runs `case` on `mesh`, the making of which began at `start`.
///
/// # Errors
/// As [`run`].
pub fn run_on(
    case: &Case,
    mesh: Mesh,
    options: &Options,
    start: Instant,
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    let _folder = options.open()?;
    match solve_on(case, mesh, options, start, false, observer)? {
        Ended::Done(outcome) => Ok(*outcome),
        Ended::Remesh(_) => Err(JobError::Interrupted),
    }
}

/// How a solution ended.
enum Ended {
    Done(Box<Outcome>),
    /// The mesh does not serve lines of contact of these widths.
    Remesh(Strips),
}

fn solve_on(
    case: &Case,
    mesh: Mesh,
    options: &Options,
    start: Instant,
    mesh_may_change: bool,
    observer: &mut dyn Observer,
) -> Result<Ended, JobError> {
    let mut scene = case.scene(mesh)?;
    let mesh_s = start.elapsed().as_secs_f64();
    observer.message(&format!(
        "{} nodes, {} hexahedra, {} bodies",
        scene.mesh.points.len(),
        scene.mesh.hexes.len(),
        scene.mesh.bodies.len()
    ));
    let checkpoint = (options.out.as_deref()).map(|out| Checkpoint::new(out, &scene));
    let restart = match checkpoint.as_ref().filter(|_| options.resume) {
        Some(checkpoint) => checkpoint.read()?,
        None => None,
    };
    if options.resume && restart.is_none() {
        observer.message("no checkpoint to go on from: from the start");
    }
    let clock = Clock::start();
    let files = options.out.as_deref().zip(checkpoint);
    let watched = mesh_may_change.then_some((case, &scene));
    let mut watch = Watch::new(observer, watched);
    let mut recorder = Recorder::new(case, files, restart.as_ref(), scene.clone(), &mut watch)?;
    let (solution, failure) = match solve::resume(&mut scene, restart.as_ref(), &mut recorder) {
        Ok(solution) => (solution, None),
        Err(unfinished) => match unfinished.solution {
            Some(solution) => (*solution, Some(unfinished.error)),
            None => return Err(unfinished.error.into()),
        },
    };
    let writing = recorder.spent();
    let history = recorder.into_history();
    let solving = clock.spent().minus(writing);
    if let Some(strips) = watch.better() {
        return Ok(Ended::Remesh(strips));
    }
    if !solution.complete && solution.last.displacement.is_empty() {
        return Err(JobError::Interrupted);
    }
    let stays = stays(&scene, &solution, observer);
    let clock = Clock::start();
    let elastic = match options.elastic_peaks {
        true => elastic_peaks(&scene, &solution, observer),
        false => None,
    };
    let timing = Timing {
        mesh_s,
        solve_s: solving.wall_s,
        solve_cpu_s: solving.cpu_s,
        write_s: writing.wall_s,
        elastic_s: clock.spent().wall_s,
        total_s: start.elapsed().as_secs_f64(),
        phases: phases(&solution.counters.timers),
    };
    let second = (elastic.as_deref(), stays.as_deref());
    let recovered = recover(&scene, reported(&scene, &solution));
    let fields = (&solution, &recovered);
    let mut summary = summarise(case, &scene, fields, second, timing, options)?;
    let remarks = [&solution.stuck, &solution.laborious].into_iter().flatten();
    summary.warnings.extend(remarks.cloned().map(Warning));
    summary
        .warnings
        .extend(turned(&scene, reported(&scene, &solution)).map(Warning));
    if let Some(text) = strips::shortcoming(case, &scene, reported(&scene, &solution)) {
        summary.warnings.push(Warning(text));
    }
    if let Some(out) = &options.out {
        summary.write(&out.join(SUMMARY))?;
        line_load::write(&summary, out)?;
        if options.report {
            let state = reported(&scene, &solution);
            let answer = (&summary, &scene, state, &recovered);
            observer.message(&report::write(case, answer, &history, out)?);
        }
    }
    if let Some(error) = failure {
        return Err(error.into());
    }
    Ok(Ended::Done(Box::new(Outcome {
        interrupted: !solution.complete || observer.cancelled(),
        scene,
        solution,
        summary,
    })))
}

/// A body that turns so far that contact is elsewhere than where it was sought, in words.
fn turned(scene: &Scene, state: &State) -> Option<String> {
    let (body, angle) = largest_turn(&scene.mesh, &state.displacement)?;
    (angle > FAR).then(|| {
        format!(
            "`{body}` turns by {angle:.3} rad: contact is sought where bodies stood before, and rotations are taken \
             as small"
        )
    })
}

/// The displacement that stays after unloading, where there is unloading. Dents can be told without
/// it, so what goes wrong here is told and no error.
fn stays(scene: &Scene, solution: &Solution, observer: &mut dyn Observer) -> Option<Vec<[f64; 3]>> {
    let stays = solve::spring_back(scene, unloaded(scene, solution)?);
    let told = |error| observer.message(&format!("dents keep an elastic part: {error}"));
    stays.map_err(told).ok()
}

/// Peaks of the same scene without plasticity, where it has yielded. The answer stands without
/// them, so what goes wrong here is told and no error.
fn elastic_peaks(
    scene: &Scene,
    solution: &Solution,
    observer: &mut dyn Observer,
) -> Option<Vec<BodyPeaks>> {
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
        return Some(peaks(scene, state, &recover(scene, state)));
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
    let recovered = recover(&elastic, &solution.last);
    Some(peaks(&elastic, &solution.last, &recovered))
}

/// Tells nothing, but stops where the observer behind it wants to.
struct Stoppable<'o>(&'o dyn Observer);

impl Observer for Stoppable<'_> {
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

fn summarise(
    case: &Case,
    scene: &Scene,
    (solution, recovered): (&Solution, &Recovered),
    (elastic, stays): (Option<&[BodyPeaks]>, Option<&[[f64; 3]]>),
    timing: Timing,
    options: &Options,
) -> Result<Summary, JobError> {
    let state = reported(scene, solution);
    let units = case.units;
    let mut inputs = SummaryInputs {
        case: &case.title,
        units: UnitLabels::of(units),
        scene,
        state,
        unloaded: unloaded(scene, solution),
        stays,
        steps: &solution.states,
        recovered,
        elastic,
        doubled: None,
        converged: solution.complete,
        counters: Counters {
            dofs: solution.counters.equations,
            iterations: solution.counters.iterations,
            factorisations: solution.counters.factorisations,
            krylov_directions: solution.counters.krylov_directions,
            kept_dofs: solution.counters.kept_equations,
            factor_entries: solution.counters.factor_entries,
        },
        timing,
        peak_memory_bytes: memory::peak(),
        measures: &[],
        bores: &bores(case),
        // Nothing but bodies and contact carries force: the tangent alone is shifted.
        checks: Checks {
            stabilisation_share: Some(0.0),
            ..Checks::default()
        },
        comparison: &[],
        assumptions: &assumptions(case),
        left_out: &left_out::list(case, scene, solution, options),
    };
    let doubled = doubled(&inputs, solution)?;
    inputs.doubled = doubled.as_deref();
    let bare = Summary::new(&inputs)?;
    let comparison = compare::rows(case, scene, &bare)?;
    inputs.comparison = &comparison;
    Ok(Summary {
        comparison: comparison.clone(),
        sizing: sizing::sizing(case, scene, &bare)?,
        ..bare
    })
}

/// What would be claimed of the solution in increments twice as large, where there is one.
fn doubled(inputs: &SummaryInputs, solution: &Solution) -> Result<Option<Vec<Claim>>, JobError> {
    let at = |step| solution.doubled.iter().find(|state| state.step == step);
    let Some(state) = at(inputs.state.step) else {
        return Ok(None);
    };
    let recovered = recover(inputs.scene, state);
    let unloaded = inputs.unloaded.and_then(|state| at(state.step));
    // What is left of the load presses either solution alike.
    let stays = (inputs.stays.zip(inputs.unloaded).zip(unloaded)).map(|((stays, one), other)| {
        let moved = one.displacement.iter().zip(&other.displacement);
        let moved = moved.map(|(one, other)| sub(*other, *one));
        let all = stays.iter().zip(moved).map(|(stays, by)| add(*stays, by));
        all.collect::<Vec<_>>()
    });
    let other = SummaryInputs {
        state,
        recovered: &recovered,
        unloaded,
        stays: stays.as_deref(),
        ..inputs.clone()
    };
    Ok(Some(Summary::new(&other)?.certificate))
}

/// Seconds by phase, under names without blanks.
fn phases(timers: &Timers) -> Named<f64> {
    let phase = |p: &Phase| (p.name().replace(' ', "_"), timers.seconds(*p));
    Named(Phase::ALL.iter().map(phase).collect())
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
