//! Does a bearing stand? Every part and every line of contact against its limit.

mod advice;
mod line;
mod part;
mod table;

use super::case_file::Position;
use super::proposal::Proposal;
use super::{Candidate, SizeError};
use crate::case::Case;
use crate::ground::file::{FileError, write_atomically};
use crate::ground::units::UnitLabels;
use crate::product::job::Outcome;
pub use advice::Advice;
use serde::Serialize;
use std::path::Path;
pub use table::render;

/// What is held against a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Hertz's p0 under the largest load per length of a line of contact, (2-49).
    ContactPressure,
    /// Largest elastic Mises stress of a part, against yield.
    ElasticMises,
    /// Largest plastic strain of a part, against none.
    PlasticStrain,
    /// Plastic strain beside a loaded edge of a contact surface.
    EdgePlasticStrain,
    /// Balance, penetration, friction: is the solution to be believed?
    Solution,
}

impl Kind {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::ContactPressure => "p0",
            Self::ElasticMises => "elastic Mises",
            Self::PlasticStrain => "plastic strain",
            Self::EdgePlasticStrain => "plastic strain at edges",
            Self::Solution => "solution",
        }
    }
}

/// How a figure stands to its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    Met,
    /// Met, but by less than the estimated error.
    MetWithinError,
    /// Missed, but by less than the estimated error.
    MissedWithinError,
    Missed,
    /// Not to be told on this mesh.
    Open,
    /// Nothing is known of the figure's error: no verdict on this mesh.
    Unresolved,
    /// Beside a loaded edge, where a figure belongs to the mesh.
    NotJudged,
}

impl Standing {
    /// Of `value`, good to ± `error`, against the most that is allowed.
    pub fn of(value: f64, error: Option<f64>, limit: f64) -> Self {
        let error = error.unwrap_or(0.0);
        match (value <= limit, (value - limit).abs() < error) {
            (true, false) => Self::Met,
            (true, true) => Self::MetWithinError,
            (false, true) => Self::MissedWithinError,
            // What is not a number is not met.
            (false, false) => Self::Missed,
        }
    }

    /// Does it miss the limit?
    pub fn is_missed(self) -> bool {
        matches!(self, Self::Missed | Self::MissedWithinError)
    }
}

/// One figure against its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    pub kind: Kind,
    /// A body or an interface.
    #[serde(rename = "where")]
    pub place: String,
    /// Across, of a line of contact.
    pub across: Option<f64>,
    /// Largest load per length of a line of contact, and where along it.
    pub line_load: Option<f64>,
    pub along: Option<f64>,
    pub value: Option<f64>,
    /// Estimated, of the value, in its unit.
    pub error: Option<f64>,
    /// Is it a peak beside a loaded edge, which belongs to the mesh?
    pub at_edge: bool,
    pub limit: Option<f64>,
    pub utilisation: Option<f64>,
    pub standing: Standing,
    pub remark: Option<String>,
}

/// All checks of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Placed {
    /// "centre" or "displaced": also the folder of the results.
    pub position: &'static str,
    /// s.
    pub offset: f64,
    pub unknowns: usize,
    pub seconds: f64,
    pub descent: Option<f64>,
    pub checks: Vec<Check>,
}

/// The verdict on a design.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// Is no limit missed, and everything resolved that is held against one?
    pub met: bool,
    /// Limits of which the mesh cannot tell.
    pub open: usize,
    pub units: UnitLabels,
    pub brinell_version: &'static str,
    pub load: f64,
    pub yield_stress: f64,
    pub capacity: f64,
    pub mesh: String,
    pub design: Candidate,
    pub positions: Vec<Placed>,
    /// What would help, where a limit is missed.
    pub advice: Option<Advice>,
}

impl Placed {
    /// Holds the result of `case` against the limits of the proposal.
    pub fn new(proposal: &Proposal, position: Position, case: &Case, outcome: &Outcome) -> Self {
        let summary = &outcome.summary;
        let mut checks = line::checks(proposal, summary);
        checks.extend(part::checks(proposal, outcome));
        let missed = outcome.missed_limits(case).into_iter();
        checks.extend(missed.map(|remark| Check {
            kind: Kind::Solution,
            place: "overall".to_string(),
            across: None,
            line_load: None,
            along: None,
            value: None,
            error: None,
            at_edge: false,
            limit: None,
            utilisation: None,
            standing: Standing::Missed,
            remark: Some(remark),
        }));
        Self {
            position: position.name(),
            offset: match position {
                Position::Centre => 0.0,
                Position::Displaced => proposal.request.roller_displacement(),
            },
            unknowns: summary.counters.dofs,
            seconds: summary.timing.total_s,
            descent: summary.answer.descent,
            checks,
        }
    }

    /// Are all limits met, and every figure resolved that must be?
    pub fn met(&self) -> bool {
        let fails = |s: Standing| s.is_missed() || s == Standing::Unresolved;
        !self.checks.iter().any(|check| fails(check.standing))
    }

    /// Is a limit missed?
    fn misses(&self) -> bool {
        self.checks.iter().any(|check| check.standing.is_missed())
    }
}

impl Verdict {
    /// The verdict on `design` from what was found at each position.
    ///
    /// # Errors
    /// Where a remedy cannot be sized.
    pub fn new(
        proposal: &Proposal,
        design: &Candidate,
        positions: Vec<Placed>,
    ) -> Result<Self, SizeError> {
        let request = &proposal.request;
        let met = positions.iter().all(Placed::met);
        let advice = match positions.iter().any(Placed::misses) {
            false => None,
            true => Some(Advice::new(request, &positions)?),
        };
        let checks = positions.iter().flat_map(|p| &p.checks);
        Ok(Self {
            met,
            open: checks.filter(|c| c.standing == Standing::Open).count(),
            units: proposal.units.clone(),
            brinell_version: env!("CARGO_PKG_VERSION"),
            load: request.load,
            yield_stress: request.yield_stress,
            capacity: request.capacity,
            mesh: request.preset.value.name().to_string(),
            design: design.clone(),
            positions,
            advice,
        })
    }

    /// Writes `verdict.json` and `verdict.md` into `folder`.
    ///
    /// # Errors
    /// [`FileError::Write`] names the path.
    pub fn write(&self, folder: &Path) -> Result<(), FileError> {
        write_atomically(&folder.join("verdict.json"), |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            writeln!(out)
        })?;
        write_atomically(&folder.join("verdict.md"), |out| {
            out.write_all(table::page(self).as_bytes())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_shows_how_sure_a_limit_is_met() {
        let of = |value, error| Standing::of(value, error, 100.0);
        assert_eq!(of(90.0, Some(5.0)), Standing::Met);
        assert_eq!(of(96.0, Some(5.0)), Standing::MetWithinError);
        assert_eq!(of(100.0, None), Standing::Met);
        assert_eq!(of(104.0, Some(5.0)), Standing::MissedWithinError);
        assert_eq!(of(106.0, Some(5.0)), Standing::Missed);
        assert_eq!(of(100.1, None), Standing::Missed);
        assert!(of(f64::NAN, Some(5.0)).is_missed());
        assert!(!Standing::Open.is_missed() && !Standing::NotJudged.is_missed());
    }
}
