//! Names of files in the folder of a run, and how one is removed.

use super::error::JobError;
use std::path::Path;

/// The summary.
pub const SUMMARY: &str = "summary.json";

/// Removes a file; one that is not there is gone already.
pub fn forget(path: &Path) -> Result<(), JobError> {
    crate::ground::file::remove(path).map_err(|error| JobError::folder(path, error))
}
