//! What can stop a job.

use crate::case::CaseError;
use crate::ground::file::FileError;
use crate::model::mesh::family::FamilyError;
use crate::model::mesh::gmsh::GmshError;
use crate::model::mesh::msh::MeshError;
use crate::product::deck::InpError;
use crate::render::OutputError;
use crate::solver::solve::SolveError;
use std::path::{Path, PathBuf};

#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum JobError {
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Mesh(Box<MeshError>),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Gmsh(#[from] GmshError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Solve(#[from] SolveError),
    #[error(transparent)]
    #[diagnostic(
        code(brinell::job::output),
        help("name another folder with --out, or make room and give write permission")
    )]
    Output(#[from] OutputError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Export(#[from] InpError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    BuiltIn(#[from] FamilyError),
    #[error("{} cannot be gone on from: {why}", path.display())]
    #[diagnostic(
        code(brinell::job::checkpoint),
        help(
            "run it from the start, without --resume, or name the folder of the earlier run with --out"
        )
    )]
    Checkpoint { path: PathBuf, why: String },
    #[error("another run writes into {}", path.display())]
    #[diagnostic(
        code(brinell::job::busy),
        help("wait for it, or name another folder with --out")
    )]
    Busy { path: PathBuf },
    #[error("interrupted before the first increment was done")]
    #[diagnostic(code(brinell::job::interrupted))]
    Interrupted,
    #[error("the closed form for {what} does not apply: {why}")]
    #[diagnostic(code(brinell::job::closed_form))]
    ClosedForm { what: String, why: String },
    #[error("the case `{case}` is a general scene on a mesh file: there is no template to mesh")]
    #[diagnostic(code(brinell::job::no_template), help("mesh it with gmsh itself"))]
    NoTemplate { case: String },
    #[error(
        "the mesh would have about {elements:.2e} elements, which takes {seconds:.0e} s to make and at least \
         {:.3} GB to solve; {:.3} GB are there",
        needed / 1e9,
        available / 1e9
    )]
    #[diagnostic(
        code(brinell::job::mesh_size),
        help(
            "make elements larger: a larger `scale`, `growth` or size in [mesh], or a preset; a length in a wrong \
             unit does this, too"
        )
    )]
    MeshSize {
        elements: f64,
        seconds: f64,
        needed: f64,
        available: f64,
    },
    #[error("{} cannot be used: {error}", path.display())]
    #[diagnostic(
        code(brinell::job::folder),
        help("name another folder with --out, or make room and give write permission")
    )]
    Folder {
        path: PathBuf,
        error: std::io::Error,
    },
}

impl From<FileError> for JobError {
    fn from(error: FileError) -> Self {
        Self::Output(error.into())
    }
}

impl From<MeshError> for JobError {
    fn from(error: MeshError) -> Self {
        Self::Mesh(Box::new(error))
    }
}

impl JobError {
    pub(crate) fn folder(path: &Path, error: std::io::Error) -> Self {
        Self::Folder {
            path: path.to_owned(),
            error,
        }
    }

    /// Did the solver fail to converge, rather than the input to make sense?
    pub fn is_not_converged(&self) -> bool {
        matches!(self, Self::Solve(error) if error.is_of_balance())
    }
}
