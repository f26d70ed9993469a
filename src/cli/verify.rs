//! `brinell verify`: the ladder of problems with known answers.

use super::{CommandResult, Status, say};
use crate::verify::{Claim, Extent, VerifyError, extreme, matrix, suites};
use clap::Args;
use std::path::Path;

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// Climb the whole ladder, the slow rungs too.
    #[arg(long)]
    pub all: bool,
    /// One family only; `extreme` runs the cases of cases/extreme at the edge of what can be solved.
    #[arg(long, value_name = "NAME")]
    pub suite: Option<String>,
    /// Write docs/verification.md, or docs/stability.md for the extreme cases.
    #[arg(long)]
    pub write: bool,
}

/// The page that `--write` writes, from the folder where the command is run.
const PAGE: &str = "docs/verification.md";

/// The suite of extreme cases, and its page.
const EXTREME: &str = "cases/extreme/suite.toml";
const EXTREME_PAGE: &str = "docs/stability.md";

/// Carries out the command.
pub fn run(args: &VerifyArgs) -> CommandResult {
    if args.suite.as_deref() == Some("extreme") {
        return run_extreme(args.write);
    }
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

fn run_extreme(write: bool) -> CommandResult {
    let bad = |report: miette::Report| (Status::BadInput, report);
    let suite = Path::new(EXTREME);
    let cases = extreme::read(suite).map_err(|error| bad(error.into()))?;
    let folder = suite.parent().unwrap_or(suite);
    say(&extreme::head());
    let outcomes = cases.iter().map(|case| {
        let outcome = case.run(folder);
        say(&extreme::line(&outcome));
        outcome
    });
    let outcomes: Vec<_> = outcomes.collect();
    let failed = outcomes.iter().filter(|o| !o.holds()).count();
    say(&format!(
        "\n{} cases, {failed} not as expected",
        outcomes.len()
    ));
    if write {
        std::fs::write(EXTREME_PAGE, extreme::page(&outcomes))
            .map_err(|error| bad(miette::miette!("{EXTREME_PAGE} cannot be written: {error}")))?;
        say(&format!("written to {EXTREME_PAGE}"));
    }
    Ok(if failed == 0 {
        Status::Done
    } else {
        Status::Failed
    })
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
