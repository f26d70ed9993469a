//! All checks of one position of the rollers.

use super::check::{LimitCheck, LimitKind};
use super::standing::Standing;
use super::{line, part};
use crate::case::Case;
use crate::product::job::Outcome;
use crate::product::size::case_file::Position;
use crate::product::size::proposal::Proposal;
use serde::Serialize;

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
    pub checks: Vec<LimitCheck>,
}

impl Placed {
    /// Holds the result of `case` against the limits of the proposal.
    pub fn new(proposal: &Proposal, position: Position, case: &Case, outcome: &Outcome) -> Self {
        let summary = &outcome.summary;
        let mut checks = line::checks(proposal, summary);
        checks.extend(part::checks(proposal, outcome));
        let missed = outcome.missed_limits(case).into_iter();
        checks.extend(missed.map(|remark| LimitCheck {
            standing: Standing::Missed,
            remark: Some(remark),
            ..LimitCheck::bare(LimitKind::Solution, "overall")
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
    pub fn misses(&self) -> bool {
        self.checks.iter().any(|check| check.standing.is_missed())
    }
}
