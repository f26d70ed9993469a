//! Why a series of meshes cannot be run.

use crate::case::CaseError;
use crate::ground::file::FileError;
use crate::model::mesh::msh::MeshError;
use crate::model::mesh::split::SplitError;
use crate::product::job::JobError;
use crate::render::OutputError;

/// A solution lacks what is to be read from it.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
#[error("the solution has no {0} to read")]
#[diagnostic(code(brinell::converge::missing))]
pub struct Missing(pub &'static str);

/// A series cannot be run, or its results cannot be read or written.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum ConvergeError {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Job(#[from] JobError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Split(#[from] SplitError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Missing(#[from] Missing),
    #[error("a convergence series needs two meshes or more, and there is {count}")]
    #[diagnostic(
        code(brinell::converge::too_few),
        help("three or more meshes also give an observed order and an extrapolated value")
    )]
    TooFew { count: usize },
    #[error("the sizes must shrink from level to level: the factor is {factor}")]
    #[diagnostic(
        code(brinell::converge::factor),
        help("give --factor more than 1 and at most 4, such as 1.414 or 2")
    )]
    Factor { factor: f64 },
    #[error("{what} cannot be chosen here: {why}")]
    #[diagnostic(code(brinell::converge::choice), help("{help}"))]
    Choice {
        what: &'static str,
        why: String,
        help: &'static str,
    },
    #[error("the stored results of other programs cannot be read: {0}")]
    #[diagnostic(code(brinell::converge::peers))]
    Peers(String),
    #[error(transparent)]
    #[diagnostic(
        code(brinell::converge::output),
        help("name another folder with --out, or make room and give write permission")
    )]
    Output(#[from] OutputError),
}

impl From<FileError> for ConvergeError {
    fn from(error: FileError) -> Self {
        Self::Output(error.into())
    }
}

impl From<CaseError> for ConvergeError {
    fn from(error: CaseError) -> Self {
        Self::Job(error.into())
    }
}

impl From<MeshError> for ConvergeError {
    fn from(error: MeshError) -> Self {
        Self::Job(error.into())
    }
}

impl ConvergeError {
    /// Is it of the mesh, so that an answer on a coarser one stands?
    pub fn is_of_mesh(&self) -> bool {
        match self {
            Self::Split(_) => true,
            Self::Job(error) => error.is_of_mesh(),
            _ => false,
        }
    }

    /// Did the solver fail to converge, rather than the input to make sense?
    pub fn is_not_converged(&self) -> bool {
        matches!(self, Self::Job(error) if error.is_not_converged())
    }
}
