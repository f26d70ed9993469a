//! The processes of rows: how they are started, and what came of one that has ended.

use super::error::SweepError;
use super::place::SweepFolder;
use super::record::{RowRecord, RowStatus};
use super::rows::{Sweep, SweepRow};
use std::fs::OpenOptions;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};

/// Where what a run prints goes.
const LOG_FILE: &str = "run.log";

/// Starts runs of rows by this program itself.
pub struct Children<'s> {
    program: PathBuf,
    sweep: &'s Sweep,
    place: &'s SweepFolder,
    resume: bool,
}

impl<'s> Children<'s> {
    /// # Errors
    /// [`SweepError::Start`] where the program cannot find itself.
    pub fn new(sweep: &'s Sweep, place: &'s SweepFolder, resume: bool) -> Result<Self, SweepError> {
        Ok(Self {
            program: std::env::current_exe().map_err(|error| SweepError::Start { error })?,
            sweep,
            place,
            resume,
        })
    }

    /// Starts a run of `row`, which stops when its standard input is closed.
    ///
    /// # Errors
    /// Where its log cannot be written or the process cannot be started.
    pub fn start(&self, row: &SweepRow, threads: usize) -> Result<Child, SweepError> {
        let path = self.place.row(row).join(LOG_FILE);
        let mut how = OpenOptions::new();
        let how = how.create(true).write(true);
        let how = how.append(self.resume).truncate(!self.resume);
        let log = how
            .open(&path)
            .map_err(|error| SweepError::folder(&path, error))?;
        let failed = |error| SweepError::Start { error };
        let mut command = Command::new(&self.program);
        command.arg("sweep").arg(&self.sweep.file);
        command.arg("--out").arg(&self.place.0);
        command.arg("--row").arg(row.number.to_string());
        command
            .arg("--threads")
            .arg(threads.to_string())
            .arg("--leash");
        if self.resume {
            command.arg("--resume");
        }
        command.stdin(Stdio::piped());
        command.stdout(log.try_clone().map_err(failed)?).stderr(log);
        command.spawn().map_err(failed)
    }

    /// What came of a row whose process has ended: its own word, where it left one.
    ///
    /// # Errors
    /// Where that of a crashed row cannot be written.
    pub fn what_came(&self, row: &SweepRow, status: ExitStatus) -> Result<RowRecord, SweepError> {
        const INTERRUPTED: i32 = 130;
        // What is not final may have been left by an earlier run.
        let stopped = status.code() == Some(INTERRUPTED);
        let fits = |record: &RowRecord| {
            let own =
                status.code().is_some() && stopped == (record.status == RowStatus::Interrupted);
            record.status.is_final() || own
        };
        if let Some(record) = RowRecord::read(self.place, row).filter(fits) {
            return Ok(record);
        }
        let record = if stopped {
            RowRecord::without(row, RowStatus::Interrupted, "stopped")
        } else {
            let message = format!("{status}; see rows/{}/{LOG_FILE}", row.name);
            RowRecord::without(row, RowStatus::Crashed, message)
        };
        record.write(self.place, row)?;
        Ok(record)
    }
}
