//! Names of files in the folder of a run, and how one is removed.

use super::error::JobError;
use std::io::ErrorKind;
use std::path::Path;

/// The summary.
pub const SUMMARY: &str = "summary.json";

/// Removes a file; one that is not there is gone already.
pub fn forget(path: &Path) -> Result<(), JobError> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(JobError::folder(path, error)),
        _ => Ok(()),
    }
}
