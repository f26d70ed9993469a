//! How a verification ended, for the command.

use crate::cli::console::Console;
use crate::cli::failure::failure;
use crate::cli::status::{ExitStatus, bad_input};
use crate::product::converge::ConvergeError;
use crate::product::size::{SizeError, Verification};

/// What a verification came to; none where it was interrupted.
pub(super) fn verdict<Verdict>(
    verification: Result<Verification<Verdict>, SizeError>,
    console: &mut Console,
) -> Result<Option<Box<Verdict>>, (ExitStatus, miette::Report)> {
    let verdict = match verification {
        Ok(Verification::Done(verdict)) => Some(verdict),
        Ok(Verification::Interrupted) => None,
        Err(SizeError::Job(error)) => return Err(failure(console, ConvergeError::Job(error))),
        Err(error) => return Err(bad_input(error)),
    };
    console.finish();
    Ok(verdict)
}
