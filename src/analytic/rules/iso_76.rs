//! The pressure that ISO 76 rates rolling bearings by: 4000 N/mm² leaves about 1e-4 of the roller's diameter.

use super::input::RuleContact;
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::error;
use crate::ground::units::{Dimension, UnitSystem};

/// N/mm², for roller bearings.
const PRESSURE: f64 = 4000.0;
/// About 58 HRC, the least that hardened bearing steel has.
const HARDNESS: f64 = 615.0;

/// The rule for `contact`.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    Rule {
        name: "ISO 76",
        formula: "p0 ≤ 4000 N/mm², which leaves about 1e-4 D; hardened bearing steel",
        source: "ISO 76, static load rating",
        standing: Standing::Indicative,
        measure: RuleMeasure::Pressure,
        limit: bound(contact).into(),
        notes: vec!["taken from 615 HB on, about 58 HRC".to_owned()],
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    let hardness = contact.hardness()?;
    let hardened = "at least 615: the rule is of hardened bearing steel";
    error::require("Brinell hardness", hardness, hardness >= HARDNESS, hardened)?;
    contact.at_pressure(PRESSURE / contact.factor_to(UnitSystem::MmNMPa, Dimension::STRESS))
}
