//! The verdict as files: `verdict.json` and `verdict.md`.

use crate::ground::file::{FileError, remove, write_json, write_text};
use crate::render::report;
use serde::Serialize;
use std::path::Path;

/// Writes a verdict and its page, `verdict.json` and `verdict.md`, into `folder`.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write_verdict(verdict: &impl Serialize, page: &str, folder: &Path) -> Result<(), FileError> {
    write_json(&folder.join("verdict.json"), verdict)?;
    write_text(&folder.join("verdict.md"), page)
}

/// Removes the verdict that an earlier design left in `folder`, with its page: it is of another load or other rollers.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn forget_verdict(folder: &Path) -> Result<(), FileError> {
    ["verdict.json", "verdict.md", report::FILE]
        .iter()
        .try_for_each(|file| {
            let path = folder.join(file);
            remove(&path).map_err(|source| FileError::Write { path, source })
        })
}
