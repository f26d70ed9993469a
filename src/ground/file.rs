//! Files that are either whole or not there.

use std::fs::{self, File, TryLockError};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use thiserror::Error;

/// Why a file could not be written or read.
#[derive(Debug, Error)]
pub enum FileError {
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
    #[error("cannot read {}: {source}", path.display())]
    Read { path: PathBuf, source: io::Error },
}

/// Writes a file under a temporary name in the same folder, makes it durable and renames it, so
/// that an interrupted run never leaves half a file. Missing folders are made.
///
/// # Errors
/// [`FileError::Write`] names the path; the temporary file is removed and an older file of that
/// name is left as it was.
pub fn write_atomically(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), FileError> {
    let failed = |source| FileError::Write {
        path: path.to_path_buf(),
        source,
    };
    let Some(name) = path.file_name() else {
        return Err(failed(io::Error::new(
            io::ErrorKind::InvalidInput,
            "it is not a file name",
        )));
    };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(failed)?;
    }
    let mut temporary = name.to_os_string();
    temporary.push(".tmp");
    let temporary = path.with_file_name(temporary);
    let written = write_through(&temporary, content).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|source| {
        // The first error is the one to tell.
        let _ = fs::remove_file(&temporary);
        failed(source)
    })
}

/// Writes a text as [`write_atomically`] does.
///
/// # Errors
/// As there.
pub fn write_text(path: &Path, text: &str) -> Result<(), FileError> {
    write_atomically(path, |out| out.write_all(text.as_bytes()))
}

/// Writes a value as JSON for readers, as [`write_atomically`] does.
///
/// # Errors
/// As there.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<(), FileError> {
    write_atomically(path, |out| {
        serde_json::to_writer_pretty(&mut *out, value)?;
        writeln!(out)
    })
}

/// Locks the file `path`, which is made where it is missing and is never reached through a link; `None` where
/// another process holds it. The system lets go of it when the process ends, however it ends.
///
/// # Errors
/// Where the file cannot be made.
pub fn lock(path: &Path) -> io::Result<Option<File>> {
    if path.is_symlink() {
        fs::remove_file(path)?;
    }
    let mut options = File::options();
    let file = options
        .write(true)
        .create(true)
        .truncate(false)
        .open(path)?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Ok(None),
        // Some network file systems know no locks: better no lock than no run.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(Some(file)),
    }
}

/// Removes a file; one that is not there is gone already.
///
/// # Errors
/// Where it is there and cannot be removed.
pub fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn write_through(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    // A link that waits there under the temporary name is removed, and never written through.
    remove(path)?;
    let mut writer = BufWriter::new(File::create_new(path)?);
    content(&mut writer)?;
    let file = writer
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    file.sync_all()
}
