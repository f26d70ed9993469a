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

impl ExitStatus {
    /// Done where all `holds`.
    pub fn of(holds: bool) -> Self {
        if holds { Self::Done } else { Self::Failed }
    }
}

/// What a command that was given something wrong comes to.
pub fn bad_input(error: impl Into<miette::Report>) -> (ExitStatus, miette::Report) {
    (ExitStatus::BadInput, error.into())
}

/// What a command comes to: a status, or one with the reason.
pub type CommandResult = Result<ExitStatus, (ExitStatus, miette::Report)>;
