//! Built-in meshes of given sizes, for problems with known answers.

pub mod disc;
pub mod grading;
pub mod problem_h;

use super::block::BlockError;
use super::join::JoinError;

/// A mesh of a family could not be made.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum FamilyError {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Block(#[from] BlockError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Join(#[from] JoinError),
}
