//! Solves a proposed bearing at the centre and displaced.

use super::SizeError;
use super::candidate::Candidate;
use super::case_file::{Position, case_file};
use super::proposal::Proposal;
use super::verdict::{DesignVerdict, Limits, Placed, forget_verdict, write_verdict};
use crate::case;
use crate::ground::file::{FileError, write_json, write_text};
use crate::ground::hash::Fnv;
use crate::product::job::{self, JobError, Options, Outcome};
use crate::render::joint::{self, JointPart};
use crate::render::{Summary, report};
use crate::solver::solve::Observer;
use std::path::{Path, PathBuf};

/// How a verification ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Verification<Verdict> {
    Done(Box<Verdict>),
    /// It was stopped, and goes on when it is given again.
    Interrupted,
}

/// A position that is solved, for the page of both.
struct SolvedCandidate {
    name: &'static str,
    case_hash: String,
    summary: Summary,
    missed: Vec<String>,
}

/// Writes the proposal (`size.json`) and the case files of `candidate` into `folder`.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(
    proposal: &Proposal,
    candidate: &Candidate,
    folder: &Path,
) -> Result<Vec<PathBuf>, FileError> {
    forget_verdict(folder)?;
    let mut written = Vec::new();
    for position in Position::of(proposal.request.capacity) {
        let path = folder.join(format!("{}.toml", position.name()));
        let text = case_file(proposal, candidate, *position);
        write_text(&path, &text)?;
        written.push(path);
    }
    let path = folder.join("size.json");
    write_json(&path, proposal)?;
    written.push(path);
    Ok(written)
}

/// Solves the case files in `folder`, each into a folder of its own name, going on where an earlier
/// run was stopped, and writes the verdict.
///
/// # Errors
/// Where a case cannot be solved.
pub fn verify(
    proposal: &Proposal,
    candidate: &Candidate,
    folder: &Path,
    observer: &mut dyn Observer,
) -> Result<Verification<DesignVerdict>, SizeError> {
    let mut positions = Vec::new();
    let mut done = Vec::new();
    for position in Position::of(proposal.request.capacity) {
        let case = case::read(&folder.join(format!("{}.toml", position.name())))?;
        observer.message(&format!("{}: {}", position.name(), case.title));
        let outcome = solved(&case, &folder.join(position.name()), observer)?;
        if outcome.interrupted {
            return Ok(Verification::Interrupted);
        }
        let offset = match position {
            Position::Centre => 0.0,
            Position::Displaced => proposal.request.roller_displacement(),
        };
        let limits = Limits::of(&proposal.request, candidate);
        let place = (position.name(), offset);
        positions.push(Placed::new(place, &limits, &case, &outcome));
        done.push(SolvedCandidate {
            name: position.name(),
            case_hash: Fnv::hex(case.source.text()),
            missed: outcome.missed_limits(&case),
            summary: outcome.summary,
        });
    }
    let parts = done.iter().map(|solved| JointPart {
        name: solved.name,
        case_hash: &solved.case_hash,
        acts: "the load of the request",
        folder: solved.name,
        summary: Ok(&solved.summary),
        missed: &solved.missed,
    });
    let about = [
        "The bearing is solved with its rollers at the centre and displaced; its verdict is in verdict.md.".to_owned(),
    ];
    let parts: Vec<JointPart> = parts.collect();
    joint::write(
        "A bearing, sized and verified",
        &about,
        &parts,
        &folder.join(report::FILE),
    )?;
    let verdict = DesignVerdict::new(proposal, candidate, positions)?;
    write_verdict(&verdict, &verdict.page(), folder)?;
    Ok(Verification::Done(Box::new(verdict)))
}

/// Solves a case into the folder `out`, going on where an earlier run was stopped.
pub(super) fn solved(
    case: &case::Case,
    out: &Path,
    observer: &mut dyn Observer,
) -> Result<Outcome, JobError> {
    let options = |resume| Options {
        out: Some(out.to_owned()),
        elastic_peaks: true,
        resume,
        report: true,
    };
    match job::run(case, &options(job::has_checkpoint(out)), observer) {
        Err(JobError::Checkpoint { path, why }) => {
            let path = path.display();
            observer.message(&format!(
                "{path} cannot be gone on from ({why}): from the start"
            ));
            job::run(case, &options(false), observer)
        }
        result => result,
    }
}
