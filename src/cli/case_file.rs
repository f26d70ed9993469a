//! The case that a command is asked for.

use crate::case::{self, Case};
use crate::product::job::JobError;
use std::path::Path;

/// The case of a file with what the arguments change: mesh preset, whole model.
pub fn read_case(path: &Path, preset: Option<&str>, full: bool) -> Result<Case, JobError> {
    let mut case = case::read(path)?;
    if let Some(preset) = preset {
        case.set_preset(preset)?;
    }
    if full {
        case.set_full()?;
    }
    Ok(case)
}
