//! Why a bearing cannot be sized.

use crate::analytic::DomainError;
use crate::case::CaseError;
use crate::case::bearing::GeometryError;
use crate::ground::file::FileError;
use crate::ground::units::UnitError;
use crate::product::job::JobError;
use crate::render::OutputError;

#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SizeError {
    #[error("{option}: {error}")]
    #[diagnostic(
        code(brinell::size::quantity),
        help("a number with its unit, in quotes: --load \"210 kip\"")
    )]
    Quantity {
        option: &'static str,
        error: UnitError,
    },
    #[error("{option} is {value}, but it must be {range}")]
    #[diagnostic(code(brinell::size::range))]
    Range {
        option: &'static str,
        value: String,
        range: &'static str,
    },
    #[error("{option} cannot be `{value}`")]
    #[diagnostic(code(brinell::size::choice), help("{choices}"))]
    Choice {
        option: &'static str,
        value: String,
        choices: String,
    },
    #[error("--capacity is missing: how far the bearing moves, 2 D_r, such as \"3 in\"")]
    #[diagnostic(
        code(brinell::size::missing),
        help("parallel rollers on flat plates have none: --template line")
    )]
    Missing,
    #[error("{option} says nothing of a bearing of --template {template}")]
    #[diagnostic(
        code(brinell::size::foreign),
        help("drop it, or name the other template")
    )]
    Foreign {
        option: &'static str,
        template: &'static str,
    },
    #[error("no bearing can be sized for this: {0}")]
    #[diagnostic(
        code(brinell::size::rule),
        help("look for a unit that is not meant, such as psi for ksi")
    )]
    SizingRule(#[from] DomainError),
    #[error("a roller of diameter {diameter} cannot be built: {error}")]
    #[diagnostic(code(brinell::size::geometry), help("{}", error.help))]
    Geometry {
        diameter: String,
        error: GeometryError,
    },
    #[error(transparent)]
    #[diagnostic(transparent)]
    Job(#[from] JobError),
    #[error(transparent)]
    #[diagnostic(
        code(brinell::size::output),
        help("name another folder with --out, or make room and give write permission")
    )]
    Output(#[from] OutputError),
}

impl From<FileError> for SizeError {
    fn from(error: FileError) -> Self {
        Self::Output(error.into())
    }
}

impl From<CaseError> for SizeError {
    fn from(error: CaseError) -> Self {
        Self::Job(error.into())
    }
}
