//! What a command comes to.

/// Exit status of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum ExitStatus {
    /// Done and converged.
    Done = 0,
    /// Solved, but a claim or limit failed.
    Failed = 1,
    BadInput = 2,
    NotConverged = 3,
    Interrupted = 130,
}

/// What a command comes to: a status, or one with the reason.
pub type CommandResult = Result<ExitStatus, (ExitStatus, miette::Report)>;
