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

/// What can stop a job.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum JobError {
    /// The case is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// The mesh file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Mesh(Box<MeshError>),
    /// Gmsh made no mesh.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Gmsh(#[from] GmshError),
    /// The scene could not be solved.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Solve(#[from] SolveError),
    /// A file could not be written.
    #[error(transparent)]
    #[diagnostic(
        code(brinell::job::output),
        help("name another folder with --out, or make room and give write permission")
    )]
    Output(#[from] OutputError),
    /// The deck could not be written.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Export(#[from] InpError),
    /// A built-in mesh could not be made.
    #[error(transparent)]
    #[diagnostic(transparent)]
    BuiltIn(#[from] FamilyError),
    /// An option that is of one case alone.
    #[error("{option} is of one case, and this file has several combinations of actions")]
    #[diagnostic(
        code(brinell::job::combinations),
        help("leave it out, or make a case file of the combination that is wanted")
    )]
    Combinations {
        /// The option.
        option: &'static str,
    },
    /// An earlier run cannot be gone on from.
    #[error("{} cannot be gone on from: {why}", path.display())]
    #[diagnostic(
        code(brinell::job::checkpoint),
        help(
            "run it from the start, without --resume, or name the folder of the earlier run with --out"
        )
    )]
    Checkpoint {
        /// The file or folder.
        path: PathBuf,
        /// Why, in words.
        why: String,
    },
    /// Another run writes into the folder.
    #[error("another run writes into {}", path.display())]
    #[diagnostic(
        code(brinell::job::busy),
        help("wait for it, or name another folder with --out")
    )]
    Busy {
        /// The file or folder.
        path: PathBuf,
    },
    /// Stopped before there was anything to tell.
    #[error("interrupted before the first increment was done")]
    #[diagnostic(code(brinell::job::interrupted))]
    Interrupted,
    /// A closed form does not apply.
    #[error("the closed form for {what} does not apply: {why}")]
    #[diagnostic(code(brinell::job::closed_form))]
    ClosedForm {
        /// What is meant, in words.
        what: String,
        /// Why, in words.
        why: String,
    },
    /// Only bearings have a template to mesh.
    #[error("the case `{case}` is a general scene on a mesh file: there is no template to mesh")]
    #[diagnostic(code(brinell::job::no_template), help("mesh it with gmsh itself"))]
    NoTemplate {
        /// Title of the case.
        case: String,
    },
    /// A mesh would take the place of a file of another kind.
    #[error("{} is there already, and is no mesh", path.display())]
    #[diagnostic(
        code(brinell::job::no_mesh),
        help("name another file with --out, or remove this one")
    )]
    NoMesh {
        /// The file.
        path: PathBuf,
    },
    /// The mesh would be far too large.
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
        /// Number of elements.
        elements: f64,
        /// Seconds that meshing takes.
        seconds: f64,
        /// Bytes that are needed.
        needed: f64,
        /// Bytes that are left.
        available: f64,
    },
    /// A folder cannot be used.
    #[error("{} cannot be used: {error}", path.display())]
    #[diagnostic(
        code(brinell::job::folder),
        help("name another folder with --out, or make room and give write permission")
    )]
    Folder {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
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

    /// Is it of the mesh, or of what solving on it takes, so that an answer on a coarser one stands?
    pub fn is_of_mesh(&self) -> bool {
        match self {
            Self::Case(_) | Self::Mesh(_) | Self::Gmsh(_) | Self::BuiltIn(_) => true,
            Self::MeshSize { .. } => true,
            Self::Solve(error) => {
                !matches!(error, SolveError::Observer(_) | SolveError::Restart(_))
            }
            _ => false,
        }
    }

    /// Did the solver fail to converge, rather than the input to make sense?
    pub fn is_not_converged(&self) -> bool {
        matches!(self, Self::Solve(error) if error.is_of_balance())
    }
}
