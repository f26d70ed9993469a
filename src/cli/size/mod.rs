//! `brinell size`: from load, steel and displacement to a bearing, and a verdict on it.

mod args;
mod crossed;
mod line;

use crate::cli::console::Console;
use crate::cli::failure::failure;
use crate::cli::status::{CommandResult, ExitStatus};
use crate::product::converge::ConvergeError;
use crate::product::size::{SizeError, Verification};
pub use args::SizeArgs;
use args::TemplateName;

/// Carries out the command.
pub fn run(args: &SizeArgs) -> CommandResult {
    match args.template {
        TemplateName::Crossed => crossed::run(args),
        TemplateName::Line => line::run(args),
    }
}

/// What a verification came to; none where it was interrupted.
fn verdict<Verdict>(
    verification: Result<Verification<Verdict>, SizeError>,
    console: &mut Console,
) -> Result<Option<Box<Verdict>>, (ExitStatus, miette::Report)> {
    let verdict = match verification {
        Ok(Verification::Done(verdict)) => Some(verdict),
        Ok(Verification::Interrupted) => None,
        Err(SizeError::Job(error)) => return Err(failure(console, ConvergeError::Job(error))),
        Err(error) => return Err((ExitStatus::BadInput, error.into())),
    };
    console.finish();
    Ok(verdict)
}
