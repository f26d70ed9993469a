//! `brinell study`: the published study, rerun.

use super::console::Console;
use super::failure::failure;
use super::output::say;
use super::status::{CommandResult, ExitStatus, bad_input};
use crate::proof::study::{self, MEMBERS, Meshes, NAME, PAGE};
use crate::render::page::PageError;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// A mesh of the study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StudyMesh {
    ReportLike,
    Resolved,
}

#[derive(Debug, Args)]
pub struct StudyArgs {
    /// The study: section-2.6.2.
    pub study: String,
    /// Only on this mesh [default: on both].
    #[arg(long, value_enum)]
    pub mesh: Option<StudyMesh>,
    /// Folder of the results [default: results/ and the name of the study].
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Threads to use [default: one a core].
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Compare docs/section-2.6.2.md with this run.
    #[arg(long, conflicts_with = "write")]
    pub check: bool,
    /// Write the figures into docs/section-2.6.2.md.
    #[arg(long)]
    pub write: bool,
}

/// Carries out the command.
pub fn run(args: &StudyArgs) -> CommandResult {
    if args.study != NAME {
        let message = format!("there is no study `{}`; there is: {NAME}", args.study);
        return Err(bad_input(miette::Report::msg(message)));
    }
    super::threads::set_threads(args.threads);
    let meshes = Meshes {
        report_like: args.mesh != Some(StudyMesh::Resolved),
        resolved: args.mesh != Some(StudyMesh::ReportLike),
    };
    let default = || Path::new("results").join(NAME);
    let out = args.out.clone().unwrap_or_else(default);
    let mut console = Console::new(true);
    let mut solved = Vec::new();
    for member in &MEMBERS {
        say(&format!("{} ...", member.name));
        let case = member.solve(meshes, &out, &mut console);
        let case = case.map_err(|error| failure(&console, error))?;
        match case {
            Some(case) => solved.push(case),
            None => {
                console.finish();
                return Ok(ExitStatus::Interrupted);
            }
        }
    }
    console.finish();
    let parts = study::parts(&solved);
    for part in &parts {
        say(&format!("\n{}\n\n{}", part.name, part.text.trim_end()));
    }
    say(&format!("\nwritten to {}", out.display()));
    let page = Path::new(PAGE);
    let bad = |error: PageError| bad_input(miette::Report::msg(error.to_string()));
    if args.write {
        study::write(page, &parts).map_err(bad)?;
        study::write_pictures(page, &solved, &out).map_err(bad)?;
        say(&format!("written to {PAGE}"));
    }
    if !args.check {
        return Ok(ExitStatus::Done);
    }
    let differences = study::check(page, &parts).map_err(bad)?;
    for d in &differences {
        say(&format!(
            "FAILED: {PAGE}, {}, {}:\n  page  {}\n  fresh {}",
            d.part, d.row, d.page, d.fresh
        ));
    }
    if differences.is_empty() {
        say(&format!("{PAGE} says what this run says"));
    }
    Ok(ExitStatus::of(differences.is_empty()))
}
