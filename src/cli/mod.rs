//! Commands: arguments and printing, one file a command.

mod case_file;
pub mod check;
mod combinations;
pub mod completions;
mod console;
pub mod converge;
pub mod export;
mod failure;
mod help;
pub mod hertz;
pub mod init;
pub mod mesh;
mod output;
mod preset;
pub mod reference;
pub mod report;
pub mod run;
mod share;
mod signals;
pub mod size;
mod status;
pub mod study;
pub mod sweep;
mod threads;
pub mod verify;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use status::bad_input;
pub use status::{CommandResult, ExitStatus};
use std::io::Write;
use std::process::ExitCode;

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
    /// Solve one case: its verdict to the terminal, summary.json and VTK files to a folder.
    Run(run::RunArgs),
    /// Look at a case and its mesh without solving: cost, gaps, mesh quality, what holds each body.
    Check(check::CheckArgs),
    /// Mesh a bearing case by gmsh.
    Mesh(mesh::MeshArgs),
    /// Write a case as a deck for CalculiX or Abaqus.
    Export(export::ExportArgs),
    /// The page of a run: where it is, and as a PDF.
    Report(report::ReportArgs),
    /// The handbook: Hertz, ring and groove figures for a roller on a plate.
    Hertz(Box<hertz::HertzArgs>),
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

/// The whole command line, as it is parsed, completed and described.
pub fn command() -> clap::Command {
    let mut command = Cli::command();
    command.build();
    let list = help::grouped(&command);
    Cli::command().help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{list}Options:\n{{options}}\
         {{after-help}}"
    ))
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
            Command::Report(args) => report::run(&args),
            Command::Converge(args) => converge::run(&args),
            Command::Study(args) => study::run(&args),
            Command::Sweep(args) => sweep::run(&args),
            Command::Verify(args) => verify::run(&args),
            Command::Completions(args) => completions::run(&args, &mut command()),
            Command::Hertz(args) => hertz::run(&args)
                .map(|()| ExitStatus::Done)
                .map_err(bad_input),
        };
        let status = status.unwrap_or_else(|(status, report)| {
            // Nobody is left to tell where even this cannot be written.
            let _ = writeln!(std::io::stderr(), "{report:?}");
            status
        });
        let status = match output::write_error() {
            Some(why) => {
                let _ = writeln!(std::io::stderr(), "cannot write standard output: {why}");
                if status == ExitStatus::Done {
                    ExitStatus::BadInput
                } else {
                    status
                }
            }
            None => status,
        };
        ExitCode::from(status as u8)
    }
}
