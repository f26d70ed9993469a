//! Built-in meshes of given sizes, for problems with known answers.

pub mod disc;
pub mod grading;
#[doc(hidden)]
pub mod problem_h;

use super::block::BlockError;
use super::join::JoinError;

/// A mesh of a family could not be made.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum FamilyError {
    /// A block of it could not be made.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Block(#[from] BlockError),
    /// Its blocks do not go together.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Join(#[from] JoinError),
}
