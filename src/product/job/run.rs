//! A run: mesh, solve, write, and once more on another mesh where the first one does not serve.

use super::checkpoint::{self, Checkpoint};
use super::clock::Clock;
use super::error::JobError;
use super::files::{SUMMARY, forget};
use super::mesh::{self, find_mesh};
use super::options::Options;
use super::outcome::{Outcome, reported};
use super::record::Recorder;
use super::report;
use super::second::{Twin, elastic_peaks};
use super::strips::{self, Watch};
use super::summarise::{Second, phases, summarise};
use crate::answer::results::recovery::recover;
use crate::case::Case;
use crate::case::bearing::Strips;
use crate::model::mesh::Mesh;
use crate::render::line_load;
use crate::render::summary::Timing;
use crate::solver::solve::{self, Observer};
use std::path::Path;
use std::time::Instant;

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
    run_beside(case, options, None, observer)
}

/// The same beside the elastic solution `twin` on a mesh of its own, which gives the elastic peaks.
///
/// # Errors
/// As [`run`].
pub fn run_beside(
    case: &Case,
    options: &Options,
    twin: Option<&Twin>,
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
        let with = (twin, mesh_may_change);
        match solve_on(&case, mesh, options, start, with, observer)? {
            Ended::Done(outcome) => return Ok(*outcome),
            Ended::Remesh(strips) => {
                observer.message(
                    "the lines of contact are not as wide as statics says: meshed once more, as found",
                );
                if let Some(out) = out {
                    // First gone: a checkpoint is of one mesh.
                    forget(&out.join(checkpoint::FILE))?;
                    // Rows of a sweep share one file of their first mesh: no writing into that.
                    forget(&out.join(mesh::FILE))?;
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
    run_on_beside(case, mesh, options, (start, None), observer)
}

/// The same beside the elastic solution `twin` on a mesh of its own, which gives the elastic peaks.
///
/// # Errors
/// As [`run`].
pub fn run_on_beside(
    case: &Case,
    mesh: Mesh,
    options: &Options,
    (start, twin): (Instant, Option<&Twin>),
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    let _folder = options.open()?;
    match solve_on(case, mesh, options, start, (twin, false), observer)? {
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
    (twin, mesh_may_change): (Option<&Twin>, bool),
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
    recorder.save()?;
    let writing = recorder.spent();
    let step = (solution.complete).then(|| reported(&scene, &solution).step);
    let history = recorder.finish(step)?;
    let solving = clock.spent().minus(writing);
    if let Some(strips) = watch.better() {
        return Ok(Ended::Remesh(strips));
    }
    if !solution.complete && solution.last.displacement.is_empty() {
        return Err(JobError::Interrupted);
    }
    let clock = Clock::start();
    let elastic = match twin {
        Some(twin) => Some(twin.peaks.clone()),
        None if options.elastic_peaks => elastic_peaks(&scene, &solution, observer),
        None => None,
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
    let second = Second {
        elastic: elastic.as_ref(),
        twin,
        stays: solution.stays.as_deref(),
    };
    let recovered = recover(&scene, reported(&scene, &solution));
    let fields = (&solution, &recovered);
    let summary = summarise(case, &scene, fields, second, timing, options)?;
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
