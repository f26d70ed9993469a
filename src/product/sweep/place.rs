//! The folder of a sweep: what lies where, and who may write.
//!
//! ```text
//! DIR/table.csv  table.jsonl  <parameter>.svg  sweep.sbatch
//!     meshes/<fingerprint>.msh.gz       each made once
//!     rows/0001-.../case.toml           the case of the row, beside what `brinell run` writes
//!                   row.json  run.log   what came of it, and what it printed
//! ```

use super::error::SweepError;
use super::rows::SweepRow;
use crate::ground::file;
use std::fs::File;
use std::path::{Path, PathBuf};

/// The folder of a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepFolder(pub PathBuf);

/// A folder of which nobody else has the lock. The system gives it back when the process ends,
/// however it ends.
#[derive(Debug)]
pub struct Lock {
    _file: File,
}

impl SweepFolder {
    pub fn row(&self, row: &SweepRow) -> PathBuf {
        self.0.join("rows").join(&row.name)
    }

    /// Where the mesh of a bearing with this fingerprint is kept.
    pub fn mesh(&self, fingerprint: &str) -> PathBuf {
        self.0.join("meshes").join(format!("{fingerprint}.msh.gz"))
    }

    /// Makes the folder and locks it.
    ///
    /// # Errors
    /// [`SweepError::Busy`] where another sweep has it, [`SweepError::Folder`] where it cannot be made.
    pub fn lock(&self) -> Result<Lock, SweepError> {
        lock(&self.0, "sweep.lock")?.ok_or_else(|| SweepError::Busy {
            path: self.0.clone(),
        })
    }
}

/// Makes `folder` and locks it by the file `name`; `None` where somebody else has it.
///
/// # Errors
/// Where the folder cannot be made or written into.
pub fn lock(folder: &Path, name: &str) -> Result<Option<Lock>, SweepError> {
    let failed = |error| SweepError::folder(folder, error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    let file = file::lock(&folder.join(name)).map_err(failed)?;
    Ok(file.map(|file| Lock { _file: file }))
}
