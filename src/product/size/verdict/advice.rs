//! What would help where a limit is missed.

use super::check::{LimitCheck, LimitKind};
use super::position::Placed;
use super::standing::SizeStanding;
use crate::ground::units::Dimension;
use crate::product::size::SizeError;
use crate::product::size::proposal::Proposal;
use crate::product::size::request::{ECCENTRIC_MARGIN, LengthRule, Request, Setting};
use serde::Serialize;

/// The next design to try.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// Options to add or change.
    pub options: String,
    pub why: String,
    pub diameter: Option<f64>,
    pub length: Option<f64>,
    #[serde(skip)]
    pub request: Request,
}

/// The margin on the load beyond what the stresses ask for, so that the next try does not miss by a hair.
const MARGIN_ON_ADVICE: f64 = 1.05;

/// By which factor the stress behind a missed limit is too high, at least.
fn short_by(check: &LimitCheck) -> f64 {
    match check.kind {
        // How much less stress it takes not to yield is not known from the strain.
        LimitKind::PlasticStrain => STRESS_WHERE_YIELDED,
        _ => check.utilisation.unwrap_or(1.0),
    }
}

/// Stress over yield that is assumed of a part that has yielded a little: its strain does not tell by how much
/// an elastic part would exceed yield.
const STRESS_WHERE_YIELDED: f64 = 1.05;

/// By which factor the stress behind the worst missed limit is too high, at least.
pub fn short_by_at_most(positions: &[Placed]) -> f64 {
    let checks = positions.iter().flat_map(|p| &p.checks);
    let missed = checks.filter(|c| c.standing.is_missed());
    missed.map(short_by).fold(1.0, f64::max)
}

impl Advice {
    /// Contact stresses go with the root of the load: the margin on it is raised by the square of what
    /// is missed.
    ///
    /// # Errors
    /// Where that cannot be sized.
    pub fn new(request: &Request, positions: &[Placed]) -> Result<Self, SizeError> {
        let checks = || positions.iter().flat_map(|p| &p.checks);
        let worst = short_by_at_most(positions);
        let before = match request.rule.value {
            LengthRule::Eccentric => request.margin.value,
            // Statics are to be tried before more is asked of them.
            LengthRule::Printed | LengthRule::Exact => {
                ECCENTRIC_MARGIN / (worst * worst * MARGIN_ON_ADVICE)
            }
        };
        let margin = (100.0 * before * worst * worst * MARGIN_ON_ADVICE).ceil() / 100.0;
        let next = Request {
            rule: Setting::or(Some(LengthRule::Eccentric), LengthRule::Eccentric),
            margin: Setting::or(Some(margin.max(1.0)), margin),
            // What is fixed and carries too little must give way.
            diameter: None,
            length: None,
            plate: None,
            ..request.clone()
        };
        let proposal = Proposal::new(&next)?;
        let choice = proposal.choice();
        let show = |value| request.units.show(value, Dimension::LENGTH);
        let mut options = format!("--rule eccentric --margin {}", next.margin.value);
        let fixed = [
            ("--diameter", request.diameter),
            ("--length", request.length),
            ("--plate", request.plate),
        ];
        let fixed: Vec<&str> = (fixed.into_iter())
            .filter_map(|(option, value)| value.map(|_| option))
            .collect();
        if !fixed.is_empty() {
            options += &format!(", with {} left open", fixed.join(" and "));
        }
        let within = checks().any(|c| c.standing == SizeStanding::MissedWithinError);
        let solution = checks().any(|c| c.kind == LimitKind::Solution && c.standing.is_missed());
        let mut why = match choice {
            Some(c) => format!("proposes rollers {} x {}", show(c.diameter), show(c.length)),
            None => format!("proposes none: {}", proposal.why),
        };
        if within {
            why += "; some miss by less than their estimated error: a finer mesh may clear them";
        }
        if solution {
            why +=
                "; a solution does not keep to its own equations: see its summary before all else";
        }
        Ok(Self {
            options,
            why,
            diameter: choice.map(|c| c.diameter),
            length: choice.map(|c| c.length),
            request: next,
        })
    }
}
