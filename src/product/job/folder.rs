//! The folder that a run writes into: one run at a time, and nothing of an earlier one that could be
//! taken for the answer of this one.

use super::error::JobError;
use super::files::{SUMMARY, forget};
use super::{checkpoint, mesh};
use crate::ground::file::lock;
use crate::render::pvd::Collection;
use crate::render::{line_load, paraview, report};
use std::fs::File;
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
    /// Makes the folder where it is missing. What an earlier run left there stays until [`clear`].
    ///
    /// # Errors
    /// [`JobError::Busy`] where another run writes there, [`JobError::Folder`] where nobody can.
    pub fn open(path: &Path) -> Result<Self, JobError> {
        std::fs::create_dir_all(path).map_err(|error| JobError::folder(path, error))?;
        let name = path.join(LOCK);
        let file = lock(&name).map_err(|error| JobError::folder(&name, error))?;
        let file = file.ok_or_else(|| JobError::Busy {
            path: path.to_owned(),
        })?;
        Ok(Self { _lock: file })
    }
}

/// Removes what an earlier run left in `folder`, of whatever case: figures, and, unless this run goes on from it, the
/// checkpoint, the VTK files and their views. The mesh that was made for this run takes the place of an older one.
///
/// # Errors
/// [`JobError::Folder`].
pub fn clear(folder: &Path, resume: bool) -> Result<(), JobError> {
    let figures = (line_load::FILES.into_iter()).chain([SUMMARY, report::FILE]);
    for file in figures {
        forget(&folder.join(file))?;
    }
    if resume {
        return Ok(());
    }
    forget(&folder.join(checkpoint::FILE))?;
    let failed = |error| JobError::folder(folder, error);
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|e| e == "pvd") {
            forget_series(&path)?;
        }
    }
    take_fresh(folder)
}

/// Removes a collection, its files and its views, if it is of our making: all of its files are called by it.
fn forget_series(path: &Path) -> Result<(), JobError> {
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let (Ok(collection), Some(stem)) = (Collection::open(path), stem) else {
        return Ok(());
    };
    let files = || collection.entries().iter().map(|entry| entry.file.as_str());
    let ours = |file: &str| {
        let number = file.strip_prefix(stem).and_then(|f| f.strip_suffix(".vtu"));
        number.is_some_and(|n| n.starts_with('_') && !n.contains(std::path::is_separator))
    };
    if !files().all(ours) {
        return Ok(());
    }
    for file in files() {
        forget(&path.with_file_name(file))?;
    }
    forget(&path.with_file_name(paraview::file_name(stem)))?;
    forget(path)
}

/// Puts a mesh that was made for this run in the place of that of an earlier one.
fn take_fresh(out: &Path) -> Result<(), JobError> {
    match std::fs::rename(out.join(mesh::FRESH), out.join(mesh::FILE)) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(JobError::folder(out, error)),
        _ => Ok(()),
    }
}
