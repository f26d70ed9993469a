//! Elastic shakedown in free rolling: up to p0 = 4 k residual stress keeps later passages elastic; beyond it each one
//! makes more plastic strain. k = Y/√3 (Mises).

use super::input::RuleContact;
use super::rule::{Rule, RuleMeasure};
use super::verdict::Standing;

/// p0 over the shear yield stress.
const SHEAR: f64 = 4.0;

/// The threshold for `contact`, of the lower yield stress.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    let bound =
        (contact.yield_stress()).and_then(|y| contact.at_pressure(SHEAR * y / 3.0_f64.sqrt()));
    Rule {
        name: "elastic shakedown",
        formula: "p0 = 4 k = 2.31 Y (free rolling, no traction)",
        source: "Johnson 1985, chapter 9",
        standing: Standing::Threshold,
        measure: RuleMeasure::Pressure,
        limit: bound.into(),
        notes: Vec::new(),
    }
}
