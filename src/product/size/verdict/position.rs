//! All checks of one position of the rollers.

use super::check::{LimitCheck, LimitKind};
use super::limits::Limits;
use super::standing::SizeStanding;
use super::{line, part};
use crate::case::Case;
use crate::product::job::Outcome;
use serde::Serialize;

/// All checks of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Placed {
    /// "centre" or "displaced", or "line": also the folder of the results.
    pub position: &'static str,
    /// s.
    pub offset: f64,
    pub unknowns: usize,
    pub seconds: f64,
    pub descent: Option<f64>,
    pub checks: Vec<LimitCheck>,
}

impl Placed {
    /// Holds the result of `case`, at a position of this name and offset, against limits.
    pub fn new(
        (position, offset): (&'static str, f64),
        limits: &Limits,
        case: &Case,
        outcome: &Outcome,
    ) -> Self {
        let summary = &outcome.summary;
        let mut checks = line::checks(limits, summary);
        checks.extend(part::checks(limits.yield_stress, outcome));
        let missed = outcome.missed_limits(case).into_iter();
        checks.extend(missed.map(|remark| LimitCheck {
            standing: SizeStanding::Missed,
            remark: Some(remark),
            ..LimitCheck::bare(LimitKind::Solution, "overall")
        }));
        Self {
            position,
            offset,
            unknowns: summary.counters.dofs,
            seconds: summary.timing.total_s,
            descent: summary.answer.descent,
            checks,
        }
    }

    /// Are all limits met, and every figure resolved that must be?
    pub fn met(&self) -> bool {
        let fails = |s: SizeStanding| s.is_missed() || s == SizeStanding::Unresolved;
        !self.checks.iter().any(|check| fails(check.standing))
    }

    /// Is a limit missed?
    pub fn misses(&self) -> bool {
        self.checks.iter().any(|check| check.standing.is_missed())
    }
}
