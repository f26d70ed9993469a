//! p0 ≤ 1.65 σ_y, (2-49) of the reference study.

use super::input::RuleContact;
use super::rule::{Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::sizing::PRESSURE_LIMIT;

/// The rule for `contact`; σ_y is the lower of the two.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    let bound = (contact.yield_stress()).and_then(|y| contact.at_pressure(PRESSURE_LIMIT * y));
    Rule {
        name: "(2-49)",
        formula: "p0 ≤ 1.65 σ_y",
        source: "reference study",
        standing: Standing::Rule,
        measure: RuleMeasure::Pressure,
        limit: bound.into(),
        notes: Vec::new(),
    }
}
