//! Writes proposed rollers as a case, solves it, and says whether they stand.

use super::candidate::LineCandidate;
use super::case_file::case_file;
use super::proposal::LineProposal;
use super::request::LineRequest;
use crate::case;
use crate::ground::file::{FileError, write_json, write_text};
use crate::ground::units::UnitLabels;
use crate::product::size::SizeError;
use crate::product::size::verdict::{
    Checked, Design, Limits, Placed, forget_verdict, page, render_checked, short_by_at_most,
    write_verdict,
};
use crate::product::size::verify::{Verification, solved};
use crate::solver::solve::Observer;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The case file, without the ending, and the folder of its results.
const NAME: &str = "line";
/// The margin beyond what is missed, so that the next try does not miss by a hair.
const MARGIN_ON_ADVICE: f64 = 1.05;

/// The verdict on parallel rollers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineVerdict {
    /// Is no limit missed, and everything resolved that is held against one?
    pub met: bool,
    pub units: UnitLabels,
    pub brinell_version: &'static str,
    pub load: f64,
    pub yield_stress: f64,
    pub mesh: String,
    pub design: LineCandidate,
    pub found: Placed,
    /// The margin that would help, where a limit is missed.
    pub advised_margin: Option<f64>,
}

impl LineVerdict {
    /// The request that the verdict advises, where a limit is missed: what is fixed and carries too little gives way.
    pub fn advised(&self, request: &LineRequest) -> Option<LineRequest> {
        let mut next = request.clone();
        next.margin.value = self.advised_margin?;
        next.length = None;
        Some(next)
    }

    /// On the terminal, every line ended.
    pub fn render(&self) -> String {
        render_checked(&self.checked())
    }

    fn checked(&self) -> Checked<'_> {
        let advice = self.advised_margin.map(|margin| {
            format!("--margin {margin}, with --length left open, which asks for longer rollers")
        });
        Checked {
            units: &self.units,
            positions: std::slice::from_ref(&self.found),
            advice,
        }
    }

    fn page(&self) -> String {
        let (c, length) = (&self.design, &self.units.length);
        let rollers = format!("{} parallel, {} {length} plates", c.rollers, c.plate);
        let design = Design {
            load: self.load,
            yield_stress: self.yield_stress,
            about: format!("rollers {} x {} {length}, {rollers}", c.diameter, c.length),
            mesh: &self.mesh,
        };
        page(&self.checked(), &design)
    }
}

/// Writes the proposal (`size.json`) and the case file of `candidate` into `folder`.
///
/// # Errors
/// [`FileError::Write`] names the path.
pub fn write(
    proposal: &LineProposal,
    candidate: &LineCandidate,
    folder: &Path,
) -> Result<Vec<PathBuf>, FileError> {
    forget_verdict(folder)?;
    let case = folder.join(format!("{NAME}.toml"));
    let text = case_file(proposal, candidate, NAME);
    write_text(&case, &text)?;
    let json = folder.join("size.json");
    write_json(&json, proposal)?;
    Ok(vec![case, json])
}

/// Solves the case file in `folder`, going on where an earlier run was stopped, and writes the verdict.
///
/// # Errors
/// Where the case cannot be solved.
pub fn verify(
    proposal: &LineProposal,
    candidate: &LineCandidate,
    folder: &Path,
    observer: &mut dyn Observer,
) -> Result<Verification<LineVerdict>, SizeError> {
    let request = &proposal.request;
    let case = case::read(&folder.join(format!("{NAME}.toml")))?;
    observer.message(&format!("{NAME}: {}", case.title));
    let outcome = solved(&case, &folder.join(NAME), observer)?;
    if outcome.interrupted {
        return Ok(Verification::Interrupted);
    }
    let limits = Limits {
        pressure: request.limit.value * request.yield_stress,
        yield_stress: request.yield_stress,
        radius: 0.5 * candidate.diameter,
    };
    let found = Placed::new((NAME, 0.0), &limits, &case, &outcome);
    let advised_margin = found.misses().then(|| {
        let worst = short_by_at_most(std::slice::from_ref(&found));
        // A given length may have more margin than was asked for.
        let margin = request.margin.value * candidate.length / candidate.required_length;
        (100.0 * margin * worst * worst * MARGIN_ON_ADVICE).ceil() / 100.0
    });
    let verdict = LineVerdict {
        met: found.met(),
        units: proposal.units.clone(),
        brinell_version: env!("CARGO_PKG_VERSION"),
        load: request.load,
        yield_stress: request.yield_stress,
        mesh: request.preset.value.name().to_owned(),
        design: candidate.clone(),
        found,
        advised_margin,
    };
    write_verdict(&verdict, &verdict.page(), folder)?;
    Ok(Verification::Done(Box::new(verdict)))
}
