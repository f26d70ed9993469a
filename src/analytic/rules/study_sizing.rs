//! D L ≥ P E_s / 8 σ_y², (2-50) of the reference study with its printed constant, as a load per length.
//!
//! The L of the rule is the length that bears, (2-51): the load per length that it is asked of is that over L' - 2 D_r.

use super::input::RuleContact;
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::sizing::PRINTED;

/// The rule for `contact`; σ_y is the lower of the two, E_s the modulus of the pair.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    Rule {
        name: "(2-50), (2-51)",
        formula: "P / L ≤ 8 D σ_y² / E_s, L = L' - 2 D_r",
        source: "reference study, constant as printed",
        standing: Standing::Rule,
        measure: RuleMeasure::LineLoad,
        limit: bound(contact).into(),
        notes: Vec::new(),
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    contact.on_a_flat()?;
    let (y, e) = (contact.yield_stress()?, contact.modulus);
    contact.at_line_load(PRINTED.load_capacity(contact.input.diameter, 1.0, e, y)?)
}
