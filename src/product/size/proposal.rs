//! The table of candidates and the one that is recommended.

use super::SizeError;
use super::assumption::{SizingAssumption, assumptions};
use super::candidate::{Candidate, SLENDEREST, STOUT, square_diameter};
use super::practical::diameters;
use super::request::{LengthRule, Request};
use super::rows::rows;
use crate::ground::units::UnitLabels;
use crate::render::text::significant;
use serde::Serialize;

/// The first diameter of the table, as a share of the diameter of a roller as long as it is thick, √(D L): the
/// study's bearings have 0.61 to 0.97.
const FIRST_DIAMETER: f64 = 0.6;

/// Rows beyond the recommended one, to show what larger rollers would do.
const ROWS_BEYOND: usize = 3;

/// The most rows of a table: it ends here where no diameter will do.
const MOST_ROWS: usize = 60;

/// What is proposed for a request.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Proposal {
    pub units: UnitLabels,
    #[serde(skip)]
    pub request: Request,
    pub candidates: Vec<Candidate>,
    /// The recommended one, by its place in the table; none where no diameter will do.
    pub recommended: Option<usize>,
    /// Why that one, or why none.
    pub why: String,
    pub assumptions: Vec<SizingAssumption>,
}

impl Proposal {
    /// Sizes a bearing.
    ///
    /// # Errors
    /// [`SizeError`] for a request that no bearing can meet.
    pub fn new(request: &Request) -> Result<Self, SizeError> {
        request.check()?;
        let candidates = candidates(request)?;
        let recommended = candidates
            .iter()
            .position(|c| c.rolls() && will_do(request, c));
        let why = why(request, &candidates, recommended);
        let units = request.units;
        Ok(Self {
            units: UnitLabels::of(units),
            assumptions: assumptions(request),
            request: request.clone(),
            candidates,
            recommended,
            why,
        })
    }

    /// The recommended bearing.
    pub fn choice(&self) -> Option<&Candidate> {
        self.candidates.get(self.recommended?)
    }
}

fn candidates(request: &Request) -> Result<Vec<Candidate>, SizeError> {
    if let Some(diameter) = request.diameter {
        return Ok(vec![Candidate::new(request, diameter)?]);
    }
    let first = FIRST_DIAMETER * square_diameter(request)?;
    let tried = diameters(request.units, first).take(MOST_ROWS);
    let tried = tried.map(|diameter| Candidate::new(request, diameter));
    let stubby = |candidate: &Candidate| candidate.slenderness < 0.5;
    rows(
        tried,
        ROWS_BEYOND,
        |candidate| will_do(request, candidate),
        stubby,
    )
}

/// Is the rule to be believed for these proportions? A diameter that is fixed is.
fn will_do(request: &Request, candidate: &Candidate) -> bool {
    let most = match request.rule.value {
        LengthRule::Eccentric => STOUT,
        LengthRule::Printed | LengthRule::Exact => SLENDEREST,
    };
    let asked = request.diameter.is_some();
    asked || candidate.slenderness <= most && candidate.is_long_enough()
}

fn why(request: &Request, candidates: &[Candidate], recommended: Option<usize>) -> String {
    let Some(choice) = recommended.and_then(|r| candidates.get(r)) else {
        let steepest = candidates
            .iter()
            .map(|c| c.largest_slope)
            .fold(0.0, f64::max);
        return if candidates.iter().any(Candidate::rolls) {
            "no diameter of the table carries the load with rollers that are neither too short \
                     nor too slender: fix one with --diameter, or leave the length open"
                .to_string()
        } else {
            format!(
                "the rollers slide: at a friction of {} (2-39) allows a slope of {:.2} deg, and {:.2} \
                 deg are asked for; take a smaller --slope",
                request.friction.value,
                steepest.to_degrees(),
                request.slope.value.to_degrees()
            )
        };
    };
    let mut text = match (request.diameter, request.rule.value) {
        (Some(_), _) => "the diameter is given".to_string(),
        (None, LengthRule::Eccentric) => format!(
            "the smallest diameter whose rollers are no longer than {STOUT} diameters, within which \
             statics tell how a displaced roller presses; smaller ones need longer, more slender \
             rollers that press hardest where they cross"
        ),
        (None, _) => format!(
            "the smallest diameter whose rollers are no more slender (L' = {SLENDEREST:.2} D) than the \
             study's slenderest, prototype 1; the study gives no rule for it"
        ),
    };
    if request.diameter.is_some()
        && request.rule.value == LengthRule::Eccentric
        && choice.slenderness > STOUT
    {
        text += &format!(
            "; at L' = {:.2} D these rollers are too slender for statics: they may press harder where \
             they cross",
            choice.slenderness
        );
    }
    if !choice.is_long_enough() {
        text += "; its length is given, and shorter than the rule asks for";
    }
    if choice.even.utilisation > 1.0 {
        text += &format!(
            "; it misses (2-49) even under an even load: p0 is {} % of the limit",
            significant(100.0 * choice.even.utilisation, 3)
        );
    }
    text
}
