//! What a command comes to whose solution failed.

use super::console::Console;
use super::status::ExitStatus;
use crate::product::converge::ConvergeError;

/// What a solution that failed comes to, the progress bar being taken off the terminal.
pub fn failure(console: &Console, error: ConvergeError) -> (ExitStatus, miette::Report) {
    console.finish();
    // Ctrl-C reaches gmsh too, whose end then looks like a failure.
    let status = if console.interrupted() {
        ExitStatus::Interrupted
    } else if error.is_not_converged() {
        ExitStatus::NotConverged
    } else {
        ExitStatus::BadInput
    };
    (status, error.into())
}
