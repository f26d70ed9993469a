//! `brinell run` of a case with combinations of actions.

use super::console::Console;
use super::failure::failure;
use super::output::{say, say_written};
use super::status::{CommandResult, ExitStatus};
use crate::case::combinations::Combination;
use crate::product::combinations;
use crate::product::converge::ConvergeError;
use crate::product::job::{JobError, Options};
use crate::render::digest::digest;
use crate::render::joint;
use crate::render::table::text::text;

/// Solves all of them, prints which one governs and its digest, and writes the page of all.
pub fn run(
    title: &str,
    all: &[Combination],
    options: &Options,
    console: &mut Console,
) -> CommandResult {
    let (solved, ended) = combinations::solve(all, options, console);
    console.finish();
    let ended = ended.map_err(|error| failure(console, ConvergeError::from(error)));
    if solved.is_empty() {
        return ended.map(|()| ExitStatus::Done);
    }
    let parts = combinations::parts(&solved);
    let governs = parts.get(joint::governs(&parts).unwrap_or_default());
    if let Some(part) = governs
        && let Ok(summary) = part.summary
    {
        say(&digest(summary, part.missed));
    }
    say(&text(&joint::overview(&parts)));
    if let Some(out) = &options.out {
        let written = combinations::write(title, &solved, options.report, out)
            .map_err(|error| failure(console, ConvergeError::from(JobError::from(error))))?;
        say_written(&written);
    }
    // What was solved before stands, whatever became of the next.
    ended?;
    let mut failed = false;
    for one in &solved {
        let why = one.found.as_ref().err().map(ToString::to_string);
        for limit in one.missed.iter().chain(&why) {
            failed = true;
            say(&format!("FAILED: {}: {limit}", one.name));
        }
    }
    let interrupted = solved.iter().any(|one| one.interrupted);
    if let Some(error) = solved.into_iter().find_map(|one| one.found.err()) {
        return Err(failure(console, ConvergeError::from(error)));
    }
    Ok(match interrupted {
        true => ExitStatus::Interrupted,
        false => ExitStatus::of(!failed),
    })
}
