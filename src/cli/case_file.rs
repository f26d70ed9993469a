//! The case that a command is asked for.

use crate::case::{self, Case, CaseError};
use crate::product::job::JobError;
use std::path::{Path, PathBuf};

/// The case of a file with what the arguments change.
pub fn read_case(
    path: &Path,
    preset: Option<&str>,
    full: bool,
    elastic: bool,
) -> Result<Case, JobError> {
    let mut case = case::read(path)?;
    change(&mut case, preset, full, elastic)?;
    Ok(case)
}

/// What arguments change of a case: its mesh preset, the whole in place of a part, bodies that do not yield.
pub fn change(
    case: &mut Case,
    preset: Option<&str>,
    full: bool,
    elastic: bool,
) -> Result<(), CaseError> {
    if let Some(preset) = preset {
        case.set_preset(preset)?;
    }
    if full {
        case.set_full()?;
    }
    if elastic {
        case.set_elastic();
    }
    Ok(())
}

/// Where results go: into a folder of `results/` that is called as the `file`, where `out` is not given.
pub fn results_folder(out: &Option<PathBuf>, file: &Path) -> PathBuf {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    (out.clone()).unwrap_or_else(|| Path::new("results").join(stem))
}
