//! The load per inch of older AASHTO and AREMA specifications, for rollers and rockers on a flat.
//!
//! In inch, kip and ksi, whatever the units of the case:
//! ```text
//! q ≤ (F_y - 13)/20 · 0.6 d      d ≤ 25 in
//! q ≤ (F_y - 13)/20 · 3 √d       25 in < d ≤ 125 in
//! ```

use super::input::RuleContact;
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::error;
use crate::ground::units::{Dimension, UnitSystem};

/// Diameter in inch at which the formula changes.
const CHANGES: f64 = 25.0;
/// Largest diameter, in inch.
const LARGEST: f64 = 125.0;
/// ksi; steels below it have no load.
const OFFSET: f64 = 13.0;

/// The rule for `contact`; F_y is that of the weaker steel.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    Rule {
        name: "AASHTO, load per inch",
        formula: "q ≤ (F_y - 13)/20 · 0.6 d to 25 in, · 3 √d to 125 in; ksi, kip/in",
        source: "older AASHTO, AREMA",
        standing: Standing::Indicative,
        measure: RuleMeasure::LineLoad,
        limit: bound(contact).into(),
        notes: Vec::new(),
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    const OWN: UnitSystem = UnitSystem::InKipKsi;
    contact.on_a_flat()?;
    let to_own = |value, dimension| value * contact.factor_to(OWN, dimension);
    let fy = to_own(contact.yield_stress()?, Dimension::STRESS);
    let d = to_own(contact.input.diameter, Dimension::LENGTH);
    error::require("yield stress in ksi", fy, fy > OFFSET, "more than 13")?;
    error::require("diameter in inch", d, d <= LARGEST, "at most 125")?;
    let share = if d <= CHANGES {
        0.6 * d
    } else {
        3.0 * d.sqrt()
    };
    let line_load = (fy - OFFSET) / 20.0 * share;
    contact.at_line_load(line_load / contact.factor_to(OWN, Dimension::LINE_LOAD))
}
