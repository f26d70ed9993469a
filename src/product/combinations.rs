//! All combinations of a case: each solved by itself, the governing one named, one page for all.
//!
//! Contact is not linear: half of a load presses neither the same width nor half of the pressure. No combination is made
//! of others by scaling.

use super::job::{self, JobError, Options, Outcome, SUMMARY_FILE, forget};
use crate::case::combinations::Combination;
use crate::ground::file::{FileError, write_json, write_text};
use crate::ground::hash::Fnv;
use crate::render::joint::{self, JointPart};
use crate::render::verdict::missed_rules;
use crate::render::{Summary, report};
use crate::solver::solve::Observer;
use serde_json::{Value, json};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Name of the file with what governs.
pub const FILE: &str = "combinations.json";
/// Name of the case of a combination, in its folder.
const CASE: &str = "case.toml";

/// A combination that was solved, or found to have no answer.
#[derive(Debug)]
pub struct SolvedCombination {
    pub name: String,
    /// Actions and factors, in words.
    pub acts: String,
    /// The hash of its case file.
    pub case_hash: String,
    /// Its folder, in that of all.
    pub folder: String,
    /// The summary, or why the solution did not converge.
    pub found: Result<Summary, JobError>,
    /// Limits of the checks that it misses, in words.
    pub missed: Vec<String>,
    pub interrupted: bool,
}

/// Solves `combinations` one after the other, each into a folder of its own in that of `options`, and stops where one is
/// interrupted. That one collapses says nothing of the others.
///
/// Where the input of one of them is wrong, those before it come with the error.
pub fn solve(
    combinations: &[Combination],
    options: &Options,
    observer: &mut dyn Observer,
) -> (Vec<SolvedCombination>, Result<(), JobError>) {
    let mut solved: Vec<SolvedCombination> = Vec::new();
    // What an earlier run found is of other loads.
    if let Err(error) = forget_in(options.out.as_deref(), &[FILE, report::FILE]) {
        return (solved, Err(error));
    }
    for (index, combination) in combinations.iter().enumerate() {
        let folder = folder(index, &combination.name);
        let acts = combination.acts();
        observer.message(&format!("{}: {acts}", combination.name));
        let own = Options {
            out: options.out.as_ref().map(|out| out.join(&folder)),
            ..options.clone()
        };
        let (found, missed, interrupted) = match run(combination, &own, observer) {
            Ok(outcome) => {
                let missed = outcome.missed_limits(&combination.case);
                (Ok(outcome.summary), missed, outcome.interrupted)
            }
            Err(error) if error.is_not_converged() => (Err(error), Vec::new(), false),
            Err(error) => return (solved, Err(error)),
        };
        solved.push(SolvedCombination {
            name: combination.name.clone(),
            acts,
            case_hash: Fnv::hex(combination.case.source.text()),
            folder,
            found,
            missed,
            interrupted,
        });
        if interrupted {
            break;
        }
    }
    (solved, Ok(()))
}

fn forget_in(folder: Option<&Path>, files: &[&str]) -> Result<(), JobError> {
    let Some(folder) = folder else { return Ok(()) };
    files.iter().try_for_each(|file| forget(&folder.join(file)))
}

/// Solves one, and keeps its case beside the results: it stands in no file of the user's.
fn run(
    combination: &Combination,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    forget_in(options.out.as_deref(), &[SUMMARY_FILE, report::FILE])?;
    if let Some(out) = &options.out {
        let text = combination.case.source.text();
        write_text(&out.join(CASE), text)?;
    }
    job::run(&combination.case, options, observer)
}

/// A name that every file system takes.
fn folder(index: usize, name: &str) -> String {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '_'
        }
    };
    format!(
        "{}-{}",
        index + 1,
        name.chars().map(plain).collect::<String>()
    )
}

/// What the page and the tables are made of.
pub fn parts(solved: &[SolvedCombination]) -> Vec<JointPart<'_>> {
    fn part(one: &SolvedCombination) -> JointPart<'_> {
        JointPart {
            name: &one.name,
            acts: &one.acts,
            case_hash: &one.case_hash,
            folder: &one.folder,
            summary: one.found.as_ref().map_err(|error| error as &dyn Error),
            missed: &one.missed,
        }
    }
    solved.iter().map(part).collect()
}

/// Writes the page of all and `combinations.json` into the folder `out`; returns their paths.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(
    title: &str,
    solved: &[SolvedCombination],
    page: bool,
    out: &Path,
) -> Result<Vec<PathBuf>, FileError> {
    let parts = parts(solved);
    let path = out.join(FILE);
    write_json(&path, &record(title, &parts))?;
    let mut written = vec![path];
    if page {
        let about = [
            "Each combination is solved by itself: contact is not linear, so that none is scaled from another. Factors are \
             those of the case."
                .to_owned(),
        ];
        let path = out.join(report::FILE);
        joint::write(title, &about, &parts, &path)?;
        written.push(path);
    }
    Ok(written)
}

fn record(title: &str, parts: &[JointPart]) -> Value {
    let governs = joint::governs(parts).and_then(|index| parts.get(index));
    let one = |part: &JointPart| {
        let summary = part.summary.ok();
        let most = summary.and_then(joint::governing);
        let rules = summary.map(missed_rules).unwrap_or_default();
        let missed: Vec<&String> = part.missed.iter().chain(&rules).collect();
        json!({
            "name": part.name,
            "acts": part.acts,
            "folder": part.folder,
            "applied_load": summary.map(|summary| summary.answer.applied_load),
            "converged": summary.is_some_and(|summary| summary.answer.converged),
            "verdict": part.verdict().head,
            "error": part.summary.err().map(ToString::to_string),
            "missed": missed,
            "governing": most.map(|most| json!({
                "what": most.what,
                "utilisation": most.utilisation,
                "error": most.error,
                "resolved": most.resolved,
            })),
        })
    };
    json!({
        "case": title,
        "units": parts.iter().find_map(|part| Some(&part.summary.ok()?.units)),
        "governs": governs.map(|part| part.name),
        "combinations": parts.iter().map(one).collect::<Vec<Value>>(),
    })
}
