//! `brinell report`: the page of a run, on paper.

use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::product::print::{self, Paper};
use crate::render::report;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PaperArgument {
    A4,
    Letter,
}

#[derive(Debug, Args)]
#[command(after_help = "Example:
  brinell report results/case --pdf --paper letter")]
pub struct ReportArgs {
    /// The folder of a run.
    pub folder: PathBuf,
    /// Print the page to report.pdf beside it, which needs Chromium.
    #[arg(long)]
    pub pdf: bool,
    /// The paper that it is printed on.
    #[arg(long, value_enum, default_value = "a4", requires = "pdf")]
    pub paper: PaperArgument,
}

/// Carries out the command.
pub fn run(args: &ReportArgs) -> CommandResult {
    if !args.pdf {
        let page = args.folder.join(report::FILE);
        if let Err(error) = std::fs::metadata(&page) {
            let error = print::PrintError::Page(page, error);
            return Err(bad_input(error));
        }
        say(&format!(
            "{}: open it in a browser, or print it with --pdf",
            page.display()
        ));
        return Ok(ExitStatus::Done);
    }
    let paper = match args.paper {
        PaperArgument::A4 => Paper::A4,
        PaperArgument::Letter => Paper::Letter,
    };
    let printed = print::print(&args.folder, paper).map_err(bad_input)?;
    say(&format!("written to {}", printed.display()));
    Ok(ExitStatus::Done)
}
