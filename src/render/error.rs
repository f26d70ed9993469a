//! Why something could not be put out.

use crate::ground::file::FileError;
use crate::model::state::Misfit;
use std::path::PathBuf;
use thiserror::Error;

/// Why something could not be put out.
#[derive(Debug, Error)]
pub enum OutputError {
    #[error(transparent)]
    File(#[from] FileError),
    #[error("{}: line {line} is not a line of a collection that Brinell wrote", path.display())]
    NotACollection { path: PathBuf, line: usize },
    #[error(transparent)]
    Misfit(#[from] Misfit),
    #[error("the mesh has no surface that carries the pressure of contact pair {pair}")]
    NoCarrier { pair: String },
    #[error("the plot {} cannot be drawn: {why}", path.display())]
    Plot { path: PathBuf, why: String },
}
