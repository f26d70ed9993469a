//! Contact of cylinders by AASHTO LRFD, of loads of the service limit state.

use super::input::RuleContact;
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;

/// The factor of the rule.
const FACTOR: f64 = 8.0;

/// The rule for `contact`; F_y is the lower of the two, E_s the modulus of the pair.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    Rule {
        name: "AASHTO LRFD",
        formula: "P ≤ 8 W D1 / (1 - D1/D2) F_y² / E_s",
        source: "AASHTO LRFD, service loads",
        standing: Standing::Indicative,
        measure: RuleMeasure::LineLoad,
        limit: bound(contact).into(),
        notes: Vec::new(),
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    let (fy, es) = (contact.yield_stress()?, contact.modulus);
    // D1 / (1 - D1/D2) is twice the effective radius.
    let diameter = 2.0 * contact.radius;
    contact.at_line_load(FACTOR * diameter * (fy / es) * fy)
}
