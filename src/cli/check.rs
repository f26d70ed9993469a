//! `brinell check`: a case and its mesh looked at, but not solved.

use super::case_file::read_case;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::product::job::{self, JobError};
use crate::render::check::{Check, render};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    after_help = "Exit status: 0 ready to run, 1 a run would fail (a body that nothing holds, \
                        too little memory), 2 bad input. Warnings do not change it."
)]
pub struct CheckArgs {
    /// The case file.
    pub case: PathBuf,
    /// Mesh preset of a bearing [default: that of the case].
    #[arg(long, value_name = "PRESET", value_parser = super::preset::parser())]
    pub mesh: Option<String>,
    /// Model the whole bearing though it is symmetric.
    #[arg(long)]
    pub full: bool,
    /// Keep every body elastic.
    #[arg(long)]
    pub elastic: bool,
    /// Print JSON instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Carries out the command.
pub fn run(args: &CheckArgs) -> CommandResult {
    let check = checked(args).map_err(bad_input)?;
    let text = if args.json {
        serde_json::to_string_pretty(&check)
            .map_err(|error| bad_input(miette::Report::msg(error.to_string())))?
    } else {
        render(&check)
    };
    say(text.trim_end());
    Ok(ExitStatus::of(check.problems.is_empty()))
}

fn checked(args: &CheckArgs) -> Result<Check, JobError> {
    let case = read_case(&args.case, args.mesh.as_deref(), args.full, args.elastic)?;
    // JSON stands alone on standard output.
    let mut told = |line: &str| {
        if !args.json {
            say(line);
        }
    };
    job::check(&case, &mut told)
}
