//! What is taken for granted where the request leaves something open.

use super::candidate::PLATE_TO_WALL;
use super::request::{LengthRule, Request};
use crate::case::bearing::RollerEnd;
use crate::ground::units::Dimension;
use serde::Serialize;

/// One assumption.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SizingAssumption {
    /// The option that changes it.
    pub option: &'static str,
    pub value: String,
    pub why: String,
    /// Was it asked for (true), or is it the default?
    pub given: bool,
}

impl SizingAssumption {
    pub(super) fn new(option: &'static str, value: String, given: bool, why: &str) -> Self {
        Self {
            option,
            value,
            why: why.to_string(),
            given,
        }
    }
}

/// Everything that the proposal rests on beside load, yield stress and displacement.
pub fn assumptions(request: &Request) -> Vec<SizingAssumption> {
    let r = request;
    let show = |value: f64, dimension| r.units.show(value, dimension);
    let entry = SizingAssumption::new;
    vec![
        entry(
            "--modulus",
            show(r.modulus.value, Dimension::STRESS),
            r.modulus.given,
            "E_s of section 2.6.2",
        ),
        entry(
            "--poisson",
            r.poissons_ratio.value.to_string(),
            r.poissons_ratio.given,
            "steel; (2-48) has it built in",
        ),
        entry(
            "--tangent-modulus",
            show(r.tangent_modulus.value, Dimension::STRESS),
            r.tangent_modulus.given,
            "slope beyond yield, E/100: not from the study, and without effect where nothing yields",
        ),
        entry(
            "--slope",
            show(r.slope.value, Dimension::ANGLE),
            r.slope.given,
            "section 2.6.2; the study's bearings have 2 to 6 deg; more returns the bearing with more \
             force, (2-28)",
        ),
        entry(
            "--friction",
            r.friction.value.to_string(),
            r.friction.given,
            "greasy steel on steel, the cautious value of (2-40); section 2.6.2 solves with 0.15",
        ),
        entry(
            "--rolling-lever",
            show(r.rolling_lever.value, Dimension::LENGTH),
            r.rolling_lever.given,
            "δ of (2-3), steel on steel",
        ),
        entry(
            "--wall",
            format!("{} D", r.wall.value),
            r.wall.given,
            "section 2.6.2, which asks for a finite-element analysis below 0.25; prototypes 1 and 2 \
             have 0.167 and 0.215",
        ),
        plate(r),
        entry(
            "--end",
            end(r),
            r.end.given,
            "the study has square ends; elastic stress has no bound at a loaded square end",
        ),
        entry(
            "--limit",
            format!("{} of the yield stress", r.limit.value),
            r.limit.given,
            "(2-49), AASHTO 14.7.1.4, meant for the service limit state",
        ),
        rule(r),
        entry(
            "plate size",
            "L' x L'".to_string(),
            false,
            "the study does not give it",
        ),
    ]
}

fn plate(r: &Request) -> SizingAssumption {
    let (value, why) = match r.plate {
        Some(plate) => (r.units.show(plate, Dimension::LENGTH), "as asked"),
        None => (
            format!("{PLATE_TO_WALL:.3} of the wall"),
            "no rule: the study asks for an intermediate plate \"at least larger than the wall\"; its \
             bearings have 1.33 (section 2.6.2, prototype 1), 1.11 (prototype 2) and 1 (chapter 5)",
        ),
    };
    SizingAssumption::new("--plate", value, r.plate.is_some(), why)
}

fn end(r: &Request) -> String {
    match r.end.value {
        RollerEnd::Square => "square".to_string(),
        RollerEnd::Radius(radius) => format!("radius {}", r.units.show(radius, Dimension::LENGTH)),
        RollerEnd::CrownedRadius { radius, crown } => {
            let [radius, crown] = [radius, crown].map(|l| r.units.show(l, Dimension::LENGTH));
            format!("radius {radius}, crown {crown}")
        }
        RollerEnd::Crown(drop) => format!("crown {}", r.units.show(drop, Dimension::LENGTH)),
    }
}

fn rule(r: &Request) -> SizingAssumption {
    let margin = r.margin.value;
    let (value, why) = match r.rule.value {
        LengthRule::Printed => ("printed", "(2-50) with the constant 8, (2-51)"),
        LengthRule::Exact => ("exact", "(2-50) with the constant 7.783, (2-51)"),
        LengthRule::Eccentric => (
            "eccentric",
            "the longer of (2-50) and (2-51) with the exact constant, and what statics ask of a \
             displaced roller. (2-51) takes its load as even over L; statics let it rise to the end \
             that it leans on, and so do finite elements. Not from the study",
        ),
    };
    let value = format!("{value}, for {margin} times the load");
    let given = r.rule.given || r.margin.given;
    SizingAssumption::new("--rule, --margin", value, given, why)
}
