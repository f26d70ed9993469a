//! `brinell sweep`: a case and a table of parameters to many runs.

mod arguments;
mod one;
mod progress;

use super::case_file::results_folder;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::ground::memory::available;
use crate::product::sweep::{
    self, CSV, JSON_LINES, RowRecord, Sweep, SweepBudget, SweepError, SweepFolder,
};
pub use arguments::{Scheduler, SweepArgs};
use progress::SweepProgress;

/// Carries out the command.
pub fn run(args: &SweepArgs) -> CommandResult {
    let status = read(args).and_then(|(sweep, place)| match args {
        SweepArgs { row: Some(row), .. } => one::run(args, &sweep, &place, *row),
        SweepArgs { collect: true, .. } => collect(&sweep, &place),
        SweepArgs { emit: Some(_), .. } => emit(args, &sweep, &place),
        _ => local(args, &sweep, &place),
    });
    status.map_err(bad_input)
}

fn read(args: &SweepArgs) -> Result<(Sweep, SweepFolder), SweepError> {
    let sweep = sweep::read(&args.sweep)?;
    // A task reads its own row only.
    if args.row.is_none() {
        sweep.validate()?;
    }
    let out = results_folder(&args.out, &args.sweep);
    Ok((sweep, SweepFolder(out)))
}

fn local(args: &SweepArgs, sweep: &Sweep, place: &SweepFolder) -> Result<ExitStatus, SweepError> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args.threads.map_or(cores, usize::from);
    let budget = SweepBudget {
        jobs: args.jobs.map_or(threads, usize::from),
        threads,
        memory: args
            .memory
            .unwrap_or_else(|| available().map_or(f64::INFINITY, |free| 0.8 * free)),
    };
    let mut progress = SweepProgress::new(sweep, args.quiet);
    progress.say(&format!(
        "{}: {} rows, {} at a time, {:.1} GB of memory for all",
        sweep.title,
        sweep.rows.len(),
        budget.jobs.min(sweep.rows.len()),
        1e-9 * budget.memory
    ));
    let records = sweep::run(sweep, place, budget, args.resume, &mut progress);
    progress.finish();
    let records = records?;
    let missing = sweep.rows.len() - records.len();
    report(sweep, place, &records, missing)
}

fn collect(sweep: &Sweep, place: &SweepFolder) -> Result<ExitStatus, SweepError> {
    let (records, missing) = sweep::collect(sweep, place)?;
    let mut progress = SweepProgress::new(sweep, false);
    for record in &records {
        progress.line(record);
    }
    progress.finish();
    if !missing.is_empty() {
        say(&format!("not ended: rows {}", sweep::ranges(&missing)));
    }
    report(sweep, place, &records, missing.len())
}

fn emit(args: &SweepArgs, sweep: &Sweep, place: &SweepFolder) -> Result<ExitStatus, SweepError> {
    let mut progress = SweepProgress::new(sweep, args.quiet);
    let emitted = sweep::emit(sweep, place, args.resume, &mut progress);
    progress.finish();
    let (script, rows) = emitted?;
    say(&format!(
        "{} of {} rows to run",
        rows.len(),
        sweep.rows.len()
    ));
    let (file, out) = (args.sweep.display(), place.0.display());
    say(&format!(
        "submit:  sbatch {}\ngather:  brinell sweep {file} --out {out} --collect",
        script.display()
    ));
    Ok(if progress.failed() {
        ExitStatus::BadInput
    } else {
        ExitStatus::Done
    })
}

/// Draws the plots, says what came of the rows and where it is.
fn report(
    sweep: &Sweep,
    place: &SweepFolder,
    records: &[RowRecord],
    missing: usize,
) -> Result<ExitStatus, SweepError> {
    let plots = sweep::draw(place, &sweep.columns, records)?;
    let of = |status: sweep::RowStatus| records.iter().filter(|r| r.status == status).count();
    let counts = sweep::RowStatus::ALL.iter().filter(|s| of(**s) > 0);
    let mut words: Vec<String> = counts.map(|s| format!("{} {}", of(*s), s.name())).collect();
    if missing > 0 {
        words.push(format!("{missing} to do"));
    }
    say(&format!("{} rows: {}", sweep.rows.len(), words.join(", ")));
    let names = [CSV, JSON_LINES].map(|name| place.0.join(name));
    let files = names
        .iter()
        .chain(&plots)
        .map(|path| path.display().to_string());
    say(&format!(
        "written to {}",
        files.collect::<Vec<_>>().join(", ")
    ));
    Ok(match missing {
        0 => worst(records),
        _ => ExitStatus::Interrupted,
    })
}

/// The exit status of a sweep: that of its worst row.
fn worst(records: &[RowRecord]) -> ExitStatus {
    use sweep::RowStatus::{BadInput, Crashed, Interrupted, LimitsMissed, NotConverged};
    let some = |status| records.iter().any(|record| record.status == status);
    if some(Interrupted) {
        ExitStatus::Interrupted
    } else if some(BadInput) {
        ExitStatus::BadInput
    } else if some(NotConverged) || some(Crashed) {
        ExitStatus::NotConverged
    } else if some(LimitsMissed) {
        ExitStatus::Failed
    } else {
        ExitStatus::Done
    }
}
