//! Roller bearings by EN 1337-4.

use super::input::RuleContact;
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::error;

/// γ_m, as it is recommended.
const PARTIAL_FACTOR: f64 = 1.0;
/// Length over diameter.
const SLENDERNESS: [f64; 2] = [2.0, 6.0];
/// Largest rotation, in radians.
const ROTATION: f64 = 0.05;

/// The rule for `contact`; f_u is the lower of the two, E_d the modulus of the pair.
pub(super) fn rule(contact: &RuleContact) -> Rule {
    let mut notes = vec!["γ_m = 1, as recommended".to_owned()];
    let [first, second] = contact.input.sides.map(|side| side.ultimate_strength);
    let alike = match first == second {
        true => "both surfaces are to have the same nominal strength and hardness",
        false => "both surfaces are to have the same nominal strength: here they differ",
    };
    notes.push(alike.to_owned());
    if contact.input.rotation.is_none() {
        notes.push("rotation not known: at most 0.05 rad".to_owned());
    }
    Rule {
        name: "EN 1337-4",
        formula: "N' ≤ 23 R f_u² / E_d / γ_m², 2 D ≤ L ≤ 6 D, rotation ≤ 0.05 rad",
        source: "EN 1337-4:2004",
        standing: Standing::Indicative,
        measure: RuleMeasure::LineLoad,
        limit: bound(contact).into(),
        notes,
    }
}

fn bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    let input = contact.input;
    contact.on_a_flat()?;
    let slender = input.length / input.diameter;
    let [least, most] = SLENDERNESS;
    // A hair beyond: lengths are converted from other units.
    let within = (least * (1.0 - 1e-9)..=most * (1.0 + 1e-9)).contains(&slender);
    error::require("length over diameter", slender, within, "from 2 to 6")?;
    if let Some(rotation) = input.rotation {
        let allowed = rotation <= ROTATION;
        error::require("rotation in rad", rotation, allowed, "at most 0.05")?;
    }
    let fu = contact.ultimate_strength()?;
    let resistance = 23.0 * (0.5 * input.diameter) * (fu / contact.modulus) * fu;
    contact.at_line_load(resistance / PARTIAL_FACTOR.powi(2))
}
