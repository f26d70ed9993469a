//! The folder that a run writes into: one run at a time, and nothing of an earlier one that could be
//! taken for the answer of this one.

use super::{JobError, SUMMARY, checkpoint, mesh};
use crate::output::{line_load, report};
use std::fs::{File, TryLockError};
use std::io::ErrorKind;
use std::path::Path;

/// Held by the run that writes here; the system lets go of it when the run ends, however it ends.
const LOCK: &str = ".lock";

/// A folder that is this run's alone as long as it lives.
#[derive(Debug)]
pub struct Folder {
    _lock: File,
}

impl Folder {
    /// Makes the folder where it is missing and removes the results of an earlier run, but for the
    /// checkpoint where this run is to go on from it.
    ///
    /// # Errors
    /// [`JobError::Busy`] where another run writes there, [`JobError::Folder`] where nobody can.
    pub fn open(path: &Path, resume: bool) -> Result<Self, JobError> {
        std::fs::create_dir_all(path).map_err(|error| JobError::folder(path, error))?;
        let lock = path.join(LOCK);
        let file = File::create(&lock).map_err(|error| JobError::folder(&lock, error))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(JobError::Busy {
                    path: path.to_owned(),
                });
            }
            // Some network file systems know no locks: better no lock than no run.
            Err(TryLockError::Error(_)) => {}
        }
        let stale = (line_load::FILES.into_iter())
            .chain([SUMMARY, report::FILE])
            .chain(
                [checkpoint::FILE, mesh::STRIPS]
                    .into_iter()
                    .filter(|_| !resume),
            );
        for file in stale {
            forget(&path.join(file))?;
        }
        Ok(Self { _lock: file })
    }
}

pub(super) fn forget(path: &Path) -> Result<(), JobError> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(JobError::folder(path, error)),
        _ => Ok(()),
    }
}
