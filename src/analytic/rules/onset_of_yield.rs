//! First yield below an even line contact, Mises: p0 = 3.1 k = 1.79 Y for ν = 0.3.

use super::input::{RuleContact, RuleSteel};
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::subsurface::onset::line_yield_pressure;

/// The threshold for `contact`, of the side that yields first.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    Rule {
        name: "first yield",
        formula: "p0 = 1.79 Y (ν = 0.3; Mises, no traction)",
        source: "Johnson 1985, chapter 6",
        standing: Standing::Threshold,
        measure: RuleMeasure::Pressure,
        limit: bound(contact).into(),
        notes: Vec::new(),
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    contact.yield_stress()?;
    let at = |side: &RuleSteel| {
        let y = side.yield_stress.unwrap_or(f64::NAN);
        line_yield_pressure(y, side.poissons_ratio, 0.0)
    };
    let [first, second] = &contact.input.sides;
    contact.at_pressure(at(first)?.min(at(second)?))
}
