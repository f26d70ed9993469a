//! `brinell verify`: the ladder of problems with known answers.

use super::{CommandResult, Status};
use crate::verify::{Claim, Extent, VerifyError, matrix, suites};
use clap::Args;
use std::path::Path;

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// Climb the whole ladder, the slow rungs too.
    #[arg(long)]
    pub all: bool,
    /// One family only.
    #[arg(long, value_name = "NAME")]
    pub suite: Option<String>,
    /// Write docs/verification.md.
    #[arg(long)]
    pub write: bool,
}

/// The page that `--write` writes, from the folder where the command is run.
const PAGE: &str = "docs/verification.md";

/// Carries out the command.
pub fn run(args: &VerifyArgs) -> CommandResult {
    let bad = |report: miette::Report| (Status::BadInput, report);
    let extent = if args.all { Extent::All } else { Extent::Fast };
    let suites = suites(args.suite.as_deref()).map_err(|error| bad(error.into()))?;
    println!("{}", matrix::head());
    let mut claims: Vec<Claim> = Vec::new();
    let mut unsolved: Vec<(&str, VerifyError)> = Vec::new();
    for suite in suites {
        match suite.measure(extent) {
            Ok(measured) => {
                for claim in measured {
                    println!("{}", matrix::line(&claim));
                    claims.push(claim);
                }
            }
            Err(error) => {
                println!("FAILS {:12} {error}", suite.name);
                unsolved.push((suite.name, error));
            }
        }
    }
    let failed = claims.iter().filter(|c| !c.holds()).count();
    println!(
        "\n{} claims, {failed} outside their tolerance, {} families not solved",
        claims.len(),
        unsolved.len()
    );
    if args.write {
        write(Path::new(PAGE), &claims, &unsolved)
            .map_err(|error| bad(miette::miette!("{PAGE} cannot be written: {error}")))?;
        println!("written to {PAGE}");
    }
    let sound = failed == 0 && unsolved.is_empty();
    Ok(if sound { Status::Done } else { Status::Failed })
}

fn write(path: &Path, claims: &[Claim], unsolved: &[(&str, VerifyError)]) -> std::io::Result<()> {
    let mut text = matrix::page(claims);
    for (name, error) in unsolved {
        text.push_str(&format!("\nFamily `{name}` was not solved: {error}.\n"));
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(path, text)
}
