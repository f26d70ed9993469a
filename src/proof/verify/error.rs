//! Why a claim could not be measured.

use crate::analytic::DomainError;
use crate::model::mesh::block::BlockError;
use crate::model::mesh::family::FamilyError;
use crate::model::mesh::join::JoinError;
use crate::model::state::Misfit;
use crate::product::converge::Missing;
use crate::product::job::JobError;
use crate::solver::solve::SolveError;

/// The ladder could not measure a claim.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum VerifyError {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Solve(#[from] SolveError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Family(#[from] FamilyError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Block(#[from] BlockError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Join(#[from] JoinError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Job(#[from] JobError),
    #[error(transparent)]
    Domain(#[from] DomainError),
    #[error(transparent)]
    Misfit(#[from] Misfit),
    #[error("the solution has no {0} to read")]
    #[diagnostic(code(brinell::verify::missing))]
    Missing(&'static str),
    #[error("there is no suite `{name}`")]
    #[diagnostic(code(brinell::verify::suite), help("the suites are {known}"))]
    Suite { name: String, known: String },
}

impl From<Missing> for VerifyError {
    fn from(Missing(what): Missing) -> Self {
        Self::Missing(what)
    }
}
