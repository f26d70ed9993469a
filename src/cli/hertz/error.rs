//! Why `brinell hertz` has no answer.

use crate::analytic::DomainError;
use crate::case::CaseError;
use crate::case::grades::GradeError;
use crate::ground::units::UnitError;

/// What is wrong with the arguments.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum HertzError {
    /// A bare number, and nothing says in which units.
    #[error("--{option} {text} has no unit")]
    #[diagnostic(
        code(brinell::hertz::no_unit),
        help(
            "write --{option} \"{text} {unit}\", in quotes and in any unit, or name the units of all bare numbers: --units {system}"
        )
    )]
    NoUnit {
        /// The option.
        option: &'static str,
        /// What was given.
        text: String,
        /// A unit that fits.
        unit: String,
        /// A system that has it.
        system: String,
    },
    /// No quantity of that kind.
    #[error("--{option}: {error}")]
    #[diagnostic(
        code(brinell::hertz::quantity),
        help("a number with its unit, in quotes, such as \"160 mm\"")
    )]
    Quantity {
        /// The option.
        option: &'static str,
        /// What is wrong.
        error: UnitError,
    },
    /// Neither a yield stress nor a steel that has one.
    #[error("the yield stress of the {body} is not known")]
    #[diagnostic(
        code(brinell::hertz::no_yield),
        help("give --{option} \"355 MPa\", or a steel by its name: --steel S355")
    )]
    NoYield {
        /// Roller or plate.
        body: &'static str,
        /// The option.
        option: &'static str,
    },
    /// A steel that is not known, or not in that thickness.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Grade(#[from] GradeError),
    /// The file of grades.
    #[error(transparent)]
    #[diagnostic(transparent)]
    File(#[from] CaseError),
    /// An argument outside the range of a formula.
    #[error(transparent)]
    #[diagnostic(code(brinell::hertz::range))]
    Domain(#[from] DomainError),
}
