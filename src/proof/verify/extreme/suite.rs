//! The file of a suite of extreme cases.

use super::entry::Extreme;
use miette::Diagnostic;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The file of a suite.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct SuiteFile {
    case: Vec<Extreme>,
}

/// What is wrong with a suite, rather than with Brinell.
#[derive(Debug, Error, Diagnostic)]
pub enum SuiteError {
    #[error("the suite {} cannot be read: {error}", path.display())]
    #[diagnostic(
        code(brinell::verify::suite_file),
        help("run it in the folder of the project, where `cases/extreme` is")
    )]
    Read {
        path: PathBuf,
        error: std::io::Error,
    },
    #[error("the suite {} is not understood: {error}", path.display())]
    #[diagnostic(code(brinell::verify::suite_text))]
    Text {
        path: PathBuf,
        error: Box<toml::de::Error>,
    },
}

/// The cases of the suite at `path`.
///
/// # Errors
/// [`SuiteError`].
pub fn read(path: &Path) -> Result<Vec<Extreme>, SuiteError> {
    let text = std::fs::read_to_string(path).map_err(|error| SuiteError::Read {
        path: path.to_owned(),
        error,
    })?;
    let suite: SuiteFile = toml::from_str(&text).map_err(|error| SuiteError::Text {
        path: path.to_owned(),
        error: Box::new(error),
    })?;
    Ok(suite.case)
}
