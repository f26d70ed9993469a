//! `brinell sweep`: a case and a table of parameters to many runs.

mod one;
mod progress;

use super::{CommandResult, Status, say};
use crate::ground::memory::available;
use crate::product::sweep::{self, Budget, CSV, JSON_LINES, Place, Record, Sweep, SweepError};
use clap::{Args, ValueEnum};
use progress::Progress;
use std::path::{Path, PathBuf};

/// Who runs the rows, where this machine does not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Scheduler {
    Slurm,
}

/// Many cases from one: a table of parameters to a row of results each, here or by Slurm.
///
/// The sweep file names a case, and what is varied: every combination of a grid, the rows of a
/// list, or those of a CSV file, under keys of the case such as bearing.load. All rows are read before the
/// first one is run. Each runs in a process and a folder of its own; table.csv and table.jsonl have a
/// line for each that has ended, and a plot over each parameter is drawn.
#[derive(Debug, Args)]
pub struct SweepArgs {
    /// The sweep file.
    pub sweep: PathBuf,
    /// Folder for the table and the runs; by default results/ and the name of the sweep file.
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Go on with an earlier sweep into the same folder: finished rows stay as they are, half-done
    /// ones go on after their last increment. A row whose case has changed is run anew.
    #[arg(long)]
    pub resume: bool,
    /// Runs at a time [default: one a core, as far as memory goes].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Memory for all runs together, such as "6 GB": the sum of their estimates stays below
    /// [default: four fifths of what is free].
    #[arg(long, value_parser = bytes)]
    pub memory: Option<f64>,
    /// Threads for all runs together [default: one a core].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Run nothing, but write a job array that does, one task a row; sbatch submits it.
    #[arg(long, value_name = "SCHEDULER", conflicts_with_all = ["collect", "row"])]
    pub emit: Option<Scheduler>,
    /// Run nothing, but gather the rows that have ended into the table.
    #[arg(long, conflicts_with = "row")]
    pub collect: bool,
    /// Run this row only, counted from 1, as --emit has prepared it: what a task does.
    #[arg(long, value_name = "N")]
    pub row: Option<usize>,
    /// Stop when standard input ends.
    #[arg(long, hide = true)]
    pub leash: bool,
    /// Print no line for each row.
    #[arg(long, short)]
    pub quiet: bool,
}

/// Carries out the command.
pub fn run(args: &SweepArgs) -> CommandResult {
    let status = read(args).and_then(|(sweep, place)| match args {
        SweepArgs { row: Some(row), .. } => one::run(args, &sweep, &place, *row),
        SweepArgs { collect: true, .. } => collect(&sweep, &place),
        SweepArgs { emit: Some(_), .. } => emit(args, &sweep, &place),
        _ => local(args, &sweep, &place),
    });
    status.map_err(|error| (Status::BadInput, error.into()))
}

fn read(args: &SweepArgs) -> Result<(Sweep, Place), SweepError> {
    let sweep = sweep::read(&args.sweep)?;
    // A task reads its own row only.
    if args.row.is_none() {
        sweep.validate()?;
    }
    let stem = args.sweep.file_stem().unwrap_or(args.sweep.as_os_str());
    let out = args.out.clone();
    let out = out.unwrap_or_else(|| Path::new("results").join(stem));
    Ok((sweep, Place(out)))
}

fn local(args: &SweepArgs, sweep: &Sweep, place: &Place) -> Result<Status, SweepError> {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args.threads.map_or(cores, usize::from);
    let budget = Budget {
        jobs: args.jobs.map_or(threads, usize::from),
        threads,
        memory: args
            .memory
            .unwrap_or_else(|| available().map_or(f64::INFINITY, |free| 0.8 * free)),
    };
    let mut progress = Progress::new(sweep, args.quiet);
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

fn collect(sweep: &Sweep, place: &Place) -> Result<Status, SweepError> {
    let (records, missing) = sweep::collect(sweep, place)?;
    let mut progress = Progress::new(sweep, false);
    for record in &records {
        progress.line(record);
    }
    progress.finish();
    if !missing.is_empty() {
        say(&format!("not ended: rows {}", sweep::ranges(&missing)));
    }
    report(sweep, place, &records, missing.len())
}

fn emit(args: &SweepArgs, sweep: &Sweep, place: &Place) -> Result<Status, SweepError> {
    let mut progress = Progress::new(sweep, args.quiet);
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
    Ok(match progress.failed() {
        true => Status::BadInput,
        false => Status::Done,
    })
}

/// Draws the plots, says what came of the rows and where it is.
fn report(
    sweep: &Sweep,
    place: &Place,
    records: &[Record],
    missing: usize,
) -> Result<Status, SweepError> {
    let plots = sweep::draw(place, &sweep.columns, records)?;
    let of = |status: sweep::Status| records.iter().filter(|r| r.status == status).count();
    let counts = sweep::Status::ALL.iter().filter(|s| of(**s) > 0);
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
        _ => Status::Interrupted,
    })
}

/// The exit status of a sweep: that of its worst row.
fn worst(records: &[Record]) -> Status {
    use sweep::Status::{BadInput, Crashed, Interrupted, LimitsMissed, NotConverged};
    let some = |status| records.iter().any(|record| record.status == status);
    if some(Interrupted) {
        Status::Interrupted
    } else if some(BadInput) {
        Status::BadInput
    } else if some(NotConverged) || some(Crashed) {
        Status::NotConverged
    } else if some(LimitsMissed) {
        Status::Failed
    } else {
        Status::Done
    }
}

/// Bytes from a text such as `6 GB`, `800MB` or `2 GiB`.
fn bytes(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let end = text
        .find(|c: char| c.is_ascii_alphabetic())
        .unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let size = match unit.to_ascii_lowercase().as_str() {
        "mb" | "m" => 1e6,
        "gb" | "g" => 1e9,
        "tb" | "t" => 1e12,
        "mib" => f64::powi(1024.0, 2),
        "gib" => f64::powi(1024.0, 3),
        "tib" => f64::powi(1024.0, 4),
        _ => return Err("a number and MB, GB or TB are wanted, such as \"6 GB\"".to_owned()),
    };
    let number = number.trim().parse::<f64>().ok();
    let number = number.filter(|n| *n > 0.0 && n.is_finite());
    number
        .map(|n| n * size)
        .ok_or_else(|| "the number must be positive".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_read_with_its_unit() {
        assert_eq!(bytes("6 GB"), Ok(6e9));
        assert_eq!(bytes("0.5gib"), Ok(536_870_912.0));
        for wrong in ["6", "GB", "-1 GB", "nan MB", "6 kip"] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }
}
