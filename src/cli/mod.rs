//! Commands: arguments and printing, one file a command.

pub mod check;
pub mod completions;
mod console;
pub mod converge;
pub mod export;
mod help;
pub mod hertz;
pub mod init;
pub mod mesh;
mod preset;
pub mod reference;
pub mod run;
pub mod size;
pub mod study;
pub mod sweep;
pub mod verify;

use crate::case::{self, Case};
use crate::product::converge::ConvergeError;
use crate::product::job::JobError;
use clap::{FromArgMatches, Parser, Subcommand};
use console::Console;
pub use help::command;
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::OnceLock;

/// Contact stresses of roller bearings by finite elements.
#[derive(Debug, Parser)]
#[command(name = "brinell", version, arg_required_else_help = true, after_help = help::EXAMPLES)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Write a commented case file to begin with.
    Init(init::InitArgs),
    /// Size a bearing for a load, a steel and a displacement; with --verify, solve it and judge it.
    Size(Box<size::SizeArgs>),
    /// Solve one case: tables to the terminal, summary.json and VTK files to a folder.
    Run(run::RunArgs),
    /// Look at a case and its mesh without solving: cost, gaps, mesh quality, what holds each body.
    Check(check::CheckArgs),
    /// Mesh a bearing case by gmsh.
    Mesh(mesh::MeshArgs),
    /// Write a case as a deck for CalculiX or Abaqus.
    Export(export::ExportArgs),
    /// The handbook: Hertz, ring and groove figures for a roller on a plate.
    Hertz(hertz::HertzArgs),
    /// One case on a series of meshes: error against unknowns, run time and memory.
    Converge(converge::ConvergeArgs),
    /// Many cases from one: a table of parameters to a row of results each, here or by Slurm.
    Sweep(sweep::SweepArgs),
    /// The published study, rerun: printed values, the coarse mesh, resolved meshes, Hertz.
    Study(study::StudyArgs),
    /// The verification ladder: problems with known answers, and how far off the program is.
    Verify(verify::VerifyArgs),
    /// Print what a shell needs to complete commands, options and their values.
    Completions(completions::CompletionsArgs),
}

/// Exit status of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// Done and converged.
    Done = 0,
    /// Solved, but a claim or limit failed.
    Failed = 1,
    BadInput = 2,
    NotConverged = 3,
    Interrupted = 130,
}

impl Cli {
    /// The arguments of the process. Where they are wrong, or ask for help, that is printed and the
    /// process ends.
    pub fn from_command_line() -> Self {
        let matches = command().get_matches();
        Self::from_arg_matches(&matches).unwrap_or_else(|error| error.exit())
    }

    /// Carries out the command; errors are printed.
    pub fn run(self) -> ExitCode {
        let status = match self.command {
            Command::Init(args) => init::run(&args),
            Command::Size(args) => size::run(&args),
            Command::Run(args) => run::run(&args),
            Command::Check(args) => check::run(&args),
            Command::Mesh(args) => mesh::run(&args),
            Command::Export(args) => export::run(&args),
            Command::Converge(args) => converge::run(&args),
            Command::Study(args) => study::run(&args),
            Command::Sweep(args) => sweep::run(&args),
            Command::Verify(args) => verify::run(&args),
            Command::Completions(args) => completions::run(&args),
            Command::Hertz(args) => hertz::run(&args)
                .map(|()| Status::Done)
                .map_err(|error| (Status::BadInput, miette::Report::msg(error.to_string()))),
        };
        let status = status.unwrap_or_else(|(status, report)| {
            // Nobody is left to tell where even this cannot be written.
            let _ = writeln!(std::io::stderr(), "{report:?}");
            status
        });
        let status = match LOST.get() {
            Some(why) => {
                let _ = writeln!(std::io::stderr(), "cannot write standard output: {why}");
                if status == Status::Done {
                    Status::BadInput
                } else {
                    status
                }
            }
            None => status,
        };
        ExitCode::from(status as u8)
    }
}

/// Why standard output could not be written, the first time.
static LOST: OnceLock<String> = OnceLock::new();

/// Prints a line. A reader that has gone, such as `head`, stops nothing; what else cannot be written makes the
/// command fail at its end.
fn say(text: &str) {
    if let Err(error) = writeln!(std::io::stdout(), "{text}")
        && error.kind() != ErrorKind::BrokenPipe
    {
        LOST.get_or_init(|| error.to_string());
    }
}

/// What a command comes to: a status, or one with the reason.
pub type CommandResult = Result<Status, (Status, miette::Report)>;

/// What a solution that failed comes to, the progress bar being taken off the terminal.
fn failure(console: &Console, error: ConvergeError) -> (Status, miette::Report) {
    console.finish();
    // Ctrl-C reaches gmsh too, whose end then looks like a failure.
    let status = if console.interrupted() {
        Status::Interrupted
    } else if error.is_not_converged() {
        Status::NotConverged
    } else {
        Status::BadInput
    };
    (status, error.into())
}

/// The case of a file with what the arguments change: mesh preset, whole model.
fn read_case(path: &Path, preset: Option<&str>, full: bool) -> Result<Case, JobError> {
    let mut case = case::read(path)?;
    if let Some(preset) = preset {
        case.set_preset(preset)?;
    }
    if full {
        case.set_full()?;
    }
    Ok(case)
}
