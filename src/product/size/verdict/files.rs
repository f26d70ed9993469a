//! The verdict as files: `verdict.json` and `verdict.md`.

use super::design::DesignVerdict;
use crate::ground::file::{FileError, write_atomically};
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
