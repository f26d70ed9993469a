//! The verdict as files: `verdict.json` and `verdict.md`.

use super::design::DesignVerdict;
use crate::ground::file::{FileError, remove, write_atomically};
use crate::render::report;
use std::path::Path;

impl DesignVerdict {
    /// Writes `verdict.json` and `verdict.md` into `folder`.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self, folder: &Path) -> Result<(), FileError> {
        write_atomically(&folder.join("verdict.json"), |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            writeln!(out)
        })?;
        write_atomically(&folder.join("verdict.md"), |out| {
            out.write_all(self.page().as_bytes())
        })
    }
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
