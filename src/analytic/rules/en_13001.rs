//! Wheels on rails by EN 13001-3-3, line contact: static and fatigue.
//!
//! Both say the same pressure in the words of a force: p0 = 7 HB and 3 HB N/mm², over partial factors and times a
//! factor of the edge. With q = π D p0² (1 - ν²) / E_m, E_m = 2 E1 E2 / (E1 + E2), that is Hertz for ν alike.

use super::input::{RuleContact, RuleSteel};
use super::rule::{Bound, NoLimit, Rule, RuleMeasure};
use super::verdict::Standing;
use crate::analytic::error;
use crate::ground::units::{Dimension, UnitSystem};
use std::f64::consts::PI;

/// Partial factors γ_m and γ_cf.
const PARTIAL_FACTOR: f64 = 1.1;
/// p0 over the Brinell hardness, in N/mm².
const STATIC: f64 = 7.0;
/// The same of fatigue.
const FATIGUE: f64 = 3.0;
/// Of the yield stress, as hard as a hardened surface has to be, in N/mm².
const HARDENED: f64 = 0.6;
/// Exponent m of fatigue.
const EXPONENT: f64 = 10.0 / 3.0;
/// Rollings at which the limit of fatigue stands as it is.
const REFERENCE_ROLLINGS: f64 = 6.4e6;

/// The static rule.
pub(super) fn statics(contact: &RuleContact) -> Rule {
    Rule {
        name: "EN 13001-3-3, static",
        formula: "F ≤ (7 HB)² π D b (1 - ν²) f1 f2 / (E_m γ_m)",
        source: "EN 13001-3-3, wheel on rail",
        standing: Standing::Indicative,
        measure: RuleMeasure::LineLoad,
        limit: line_load(contact, STATIC)
            .and_then(|q| contact.at_line_load(q))
            .into(),
        notes: notes(contact),
    }
}

/// The fatigue rule; every rolling counts as under the full load.
pub(super) fn fatigue(contact: &RuleContact) -> Rule {
    Rule {
        name: "EN 13001-3-3, fatigue",
        formula: "F ≤ (3 HB)² π D b (1 - ν²) f1 f2 / (E_m γ_cf s_c^(1/m)), m = 10/3",
        source: "EN 13001-3-3, wheel on rail",
        standing: Standing::Indicative,
        measure: RuleMeasure::LineLoad,
        limit: fatigue_bound(contact).into(),
        notes: notes(contact),
    }
}

fn notes(contact: &RuleContact) -> Vec<String> {
    let mut notes = vec![
        "of crane wheels, its scope leaves roller bearings out".to_owned(),
        "γ = 1.1, f2 = 1: even load".to_owned(),
    ];
    if contact.input.overhang.is_none() {
        notes.push("f1 = 0.85, the least: overhang beyond the edge not known".to_owned());
    }
    if contact.input.sides.iter().any(|s| s.surface_hardened) {
        notes.push("depth of hardening not checked".to_owned());
    }
    notes
}

fn fatigue_bound(contact: &RuleContact) -> Result<Bound, NoLimit> {
    let line_load = line_load(contact, FATIGUE)?;
    let Some(rollings) = contact.input.rollings else {
        return Err(NoLimit::Needs("the number of rollings".to_owned()));
    };
    let history = error::positive("number of rollings", rollings)? / REFERENCE_ROLLINGS;
    contact.at_line_load(line_load / history.powf(1.0 / EXPONENT))
}

/// The load per length at `share` times the hardness of the weaker side.
fn line_load(contact: &RuleContact, share: f64) -> Result<f64, NoLimit> {
    let input = contact.input;
    contact.on_a_flat()?;
    contact.hardness()?;
    let megapascal = contact.factor_to(UnitSystem::MmNMPa, Dimension::STRESS);
    let [first, second] = &input.sides;
    let pressure = |side: &RuleSteel| allowed_pressure(side, share, megapascal);
    let pressure = pressure(first)?.min(pressure(second)?) / megapascal;
    let nu = first.poissons_ratio;
    let alike = (nu - second.poissons_ratio).abs() < 1e-9;
    let as_the_roller = "that of the roller: the rule has one ν";
    error::require(
        "Poisson's ratio of the plate",
        second.poissons_ratio,
        alike,
        as_the_roller,
    )?;
    let [e1, e2] = [first.youngs_modulus, second.youngs_modulus];
    let modulus = 2.0 * e1 / (e1 + e2) * e2;
    let resistance = pressure * (pressure / modulus) * PI * input.diameter * (1.0 - nu * nu);
    Ok(resistance * edge_factor(contact) / PARTIAL_FACTOR)
}

/// p0 of one side in N/mm²: `share` times its hardness; where the surface is hardened, that of the least hardness
/// which its core asks for.
fn allowed_pressure(side: &RuleSteel, share: f64, megapascal: f64) -> Result<f64, NoLimit> {
    let hardness = side.hardness.unwrap_or(f64::NAN);
    if !side.surface_hardened {
        return Ok(share * hardness);
    }
    let Some(core) = side.yield_stress.map(|y| y * megapascal) else {
        let what = "the yield stress of the core of a hardened steel";
        return Err(NoLimit::Needs(what.to_owned()));
    };
    let hard_enough = hardness >= HARDENED * core;
    let allowed = format!("at least 0.6 of the yield stress, {:.0}", HARDENED * core);
    error::require(
        "hardness of a hardened surface",
        hardness,
        hard_enough,
        allowed,
    )?;
    Ok(share * HARDENED * core)
}

/// f1: the edge of the shorter part presses into what stands out beyond it, the less the rounder it is.
fn edge_factor(contact: &RuleContact) -> f64 {
    let round = match contact.input.overhang {
        Some(overhang) if overhang > 0.0 => contact.input.end_radius / overhang,
        // Nothing stands out.
        Some(_) => return 1.0,
        None => 0.0,
    };
    match round {
        r if r <= 0.1 => 0.85,
        r if r <= 0.8 => (0.58 + 0.15 * r) / 0.7,
        _ => 1.0,
    }
}
