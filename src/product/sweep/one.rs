//! One row, run in this process: the only place that solves something.

use super::error::SweepError;
use super::figures::figures;
use super::place::{Lock, SweepFolder, lock};
use super::prepare::CASE;
use super::record::{self, RowRecord, RowStatus};
use super::rows::SweepRow;
use crate::case;
use crate::ground::file::write_atomically;
use crate::product::job::{self, JobError, Options, Outcome};
use crate::solver::solve::Observer;
use std::io::ErrorKind;
use std::path::Path;
use std::time::{Duration, Instant};

/// The fingerprint of the row whose checkpoint is in the folder.
const FINGERPRINT_FILE: &str = "begun";

/// A row that was solved in this process: what came of it, and the limits that it misses.
pub type SolvedRow = (Outcome, Vec<String>);

/// Runs the row that was prepared in `place`, and keeps what came of it. With `resume` a row that has
/// been finished stays as it is, and a half-done one goes on from its checkpoint. While another run
/// has the folder, such as one whose sweep was killed, this one waits. Returns the record, and the
/// outcome where the row was solved here.
///
/// # Errors
/// [`SweepError`] where the row was not prepared or its folder cannot be used. What is wrong with
/// the run itself is in the record.
pub fn run(
    row: &SweepRow,
    place: &SweepFolder,
    resume: bool,
    observer: &mut dyn Observer,
) -> Result<(RowRecord, Option<SolvedRow>), SweepError> {
    let folder = place.row(row);
    let Some(_lock) = wait(&folder, observer)? else {
        let message = "stopped while another run of the row was waited for";
        return Ok((
            RowRecord::without(row, RowStatus::Interrupted, message),
            None,
        ));
    };
    if let Some(finished) = RowRecord::read_final(place, row).filter(|_| resume) {
        return Ok((finished, None));
    }
    record::forget(&folder)?;
    let file = folder.join(CASE);
    let text = match std::fs::read_to_string(&file) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            return Err(SweepError::folder(&file, error));
        }
        text => text.unwrap_or_default(),
    };
    if text != row.text {
        return Err(SweepError::Changed {
            row: row.number,
            path: folder,
        });
    }
    let same =
        std::fs::read(folder.join(FINGERPRINT_FILE)).is_ok_and(|b| b == row.fingerprint.as_bytes());
    let start = Instant::now();
    let ended = solve(row, &file, resume && same, observer);
    let (mut record, outcome) = match ended {
        Ok((outcome, missed)) => (solved(row, &outcome, &missed), Some((outcome, missed))),
        Err(error) => (failed(row, &error, observer.cancelled()), None),
    };
    record.seconds = start.elapsed().as_secs_f64();
    record.write(place, row)?;
    Ok((record, outcome))
}

/// The lock of the row's folder, as soon as it is free; `None` where this was stopped before.
fn wait(folder: &Path, observer: &mut dyn Observer) -> Result<Option<Lock>, SweepError> {
    const PAUSE: Duration = Duration::from_millis(50);
    let mut told = false;
    loop {
        if let Some(lock) = lock(folder, "row.lock")? {
            return Ok(Some(lock));
        }
        if observer.cancelled() {
            return Ok(None);
        }
        if !told {
            observer.message("another run writes into this folder: waiting for it");
            told = true;
        }
        std::thread::sleep(PAUSE);
    }
}

fn solve(
    row: &SweepRow,
    file: &Path,
    resume: bool,
    observer: &mut dyn Observer,
) -> Result<SolvedRow, JobError> {
    let case = case::parse(&file.to_string_lossy(), &row.text)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let options = |resume| Options {
        out: Some(folder.to_owned()),
        elastic_peaks: true,
        resume,
        report: false,
    };
    if !resume {
        // First gone, then ours: a checkpoint is never taken for that of another row.
        match std::fs::remove_file(folder.join(job::CHECKPOINT_FILE)) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(JobError::folder(folder, error));
            }
            _ => {}
        }
        let begun = row.fingerprint.as_bytes();
        write_atomically(&folder.join(FINGERPRINT_FILE), |out| out.write_all(begun))?;
    }
    let outcome = match job::run(&case, &options(resume), observer) {
        Err(JobError::Checkpoint { why, .. }) => {
            observer.message(&format!(
                "from the start: the checkpoint is of no use, {why}"
            ));
            job::run(&case, &options(false), observer)?
        }
        ended => ended?,
    };
    let missed = outcome.missed_limits(&case);
    Ok((outcome, missed))
}

fn solved(row: &SweepRow, outcome: &Outcome, missed: &[String]) -> RowRecord {
    if outcome.interrupted {
        return RowRecord::without(row, RowStatus::Interrupted, "stopped");
    }
    let status = if missed.is_empty() {
        RowStatus::Done
    } else {
        RowStatus::LimitsMissed
    };
    RowRecord {
        figures: figures(&outcome.summary),
        ..RowRecord::without(row, status, missed.join("; "))
    }
}

/// What a row comes to whose run has failed, `stopped` by the user or by itself.
pub fn failed(row: &SweepRow, error: &JobError, stopped: bool) -> RowRecord {
    let status = match error {
        // Ctrl-C reaches gmsh too, whose end then looks like a failure.
        JobError::Interrupted | JobError::Gmsh(_) if stopped => RowStatus::Interrupted,
        error if error.is_not_converged() => RowStatus::NotConverged,
        _ => RowStatus::BadInput,
    };
    RowRecord::without(row, status, error.to_string())
}
