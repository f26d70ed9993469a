//! What the arguments ask, in one system of units.

use super::arguments::HertzArgs;
use super::error::HertzError;
use crate::analytic::handbook::{Handbook, Metal};
use crate::analytic::rules::{RuleInput, RuleSteel};
use crate::case::grades::{GradeSteel, Grades};
use crate::ground::units::{Dimension, Quantity, UnitError, UnitSystem};
use crate::product::size::units_of_load;

/// Young's modulus of the reference study's steel, in ksi.
const STEEL_MODULUS: f64 = 29500.0;
/// Its Poisson's ratio.
const STEEL_POISSONS_RATIO: f64 = 0.3;

/// The question for the handbook and for the rules.
#[derive(Debug)]
pub(super) struct Question {
    pub units: UnitSystem,
    pub handbook: Handbook,
    pub rules: RuleInput,
}

/// What is said of the steel of one body, each in the units of the question.
#[derive(Debug, Clone, Copy, Default)]
struct Given {
    youngs_modulus: Option<f64>,
    poissons_ratio: Option<f64>,
    yield_stress: Option<f64>,
    ultimate_strength: Option<f64>,
    hardness: Option<f64>,
}

impl Given {
    /// Where this says nothing, what `other` does.
    fn or(self, other: Self) -> Self {
        Self {
            youngs_modulus: self.youngs_modulus.or(other.youngs_modulus),
            poissons_ratio: self.poissons_ratio.or(other.poissons_ratio),
            yield_stress: self.yield_stress.or(other.yield_stress),
            ultimate_strength: self.ultimate_strength.or(other.ultimate_strength),
            hardness: self.hardness.or(other.hardness),
        }
    }
}

impl From<GradeSteel> for Given {
    fn from(steel: GradeSteel) -> Self {
        Self {
            youngs_modulus: Some(steel.youngs_modulus),
            poissons_ratio: Some(steel.poissons_ratio),
            yield_stress: steel.yield_stress,
            ultimate_strength: steel.ultimate_strength,
            hardness: steel.hardness,
        }
    }
}

/// Reads the arguments.
pub(super) fn question(args: &HertzArgs) -> Result<Question, HertzError> {
    let reader = UnitReader::new(args);
    let length = |option, text: &str| reader.quantity(option, text, Dimension::LENGTH);
    let lengths = |option, text: &Option<String>| reader.maybe(option, text, Dimension::LENGTH);
    let angle = |option, text: &Option<String>| reader.maybe(option, text, Dimension::ANGLE);
    let diameter = length("diameter", &args.diameter)?;
    let plate_thickness = lengths("plate-thickness", &args.plate_thickness)?;
    let roller_length = length("length", &args.length)?;
    let sides = steels(
        args,
        &reader,
        [diameter, plate_thickness.unwrap_or(diameter)],
    )?;
    let [roller, plate] = sides;
    let handbook = Handbook {
        diameter,
        wall: lengths("wall", &args.wall)?,
        length: roller_length,
        load: reader.quantity("load", &args.load, Dimension::FORCE)?,
        roller: metal(&roller, "roller", "yield")?,
        plate: metal(&plate, "plate", "plate-yield")?,
        plate_thickness,
        offset: lengths("offset", &args.offset)?,
        groove_angle: angle("groove-angle", &args.groove_angle)?.map(f64::to_degrees),
        friction: args.friction,
    };
    let rules = RuleInput {
        end_radius: lengths("end-radius", &args.end_radius)?.unwrap_or(0.0),
        overhang: lengths("overhang", &args.overhang)?,
        rotation: angle("rotation", &args.rotation)?,
        rollings: args.rollings,
        ..RuleInput::new(reader.units, diameter, roller_length, sides)
    };
    Ok(Question {
        units: reader.units,
        handbook,
        rules,
    })
}

/// Reads texts into one system of units.
struct UnitReader {
    units: UnitSystem,
    /// Were they named, so that bare numbers are in them?
    named: bool,
}

impl UnitReader {
    fn new(args: &HertzArgs) -> Self {
        let thought = units_of_load(&args.load).unwrap_or(UnitSystem::MmNMPa);
        Self {
            units: args.units.unwrap_or(thought),
            named: args.units.is_some(),
        }
    }

    fn maybe(
        &self,
        option: &'static str,
        text: &Option<String>,
        dimension: Dimension,
    ) -> Result<Option<f64>, HertzError> {
        let text = text.as_deref();
        text.map(|text| self.quantity(option, text, dimension))
            .transpose()
    }

    /// A quantity, or a bare number where units were named; angles in radians, bare ones in degrees.
    fn quantity(
        &self,
        option: &'static str,
        text: &str,
        dimension: Dimension,
    ) -> Result<f64, HertzError> {
        let unit = self.units.unit(dimension);
        let whole = match Quantity::parse(text) {
            Ok(bare)
                if self.named && bare.dimension() == Dimension::RATIO && !text.contains('%') =>
            {
                Quantity::parse(&format!("{} {unit}", text.trim()))
            }
            other => other,
        };
        let value = whole.and_then(|quantity| quantity.value_in(self.units, dimension));
        value.map_err(|error| match error {
            UnitError::NoUnit { text, .. } => HertzError::NoUnit {
                option,
                text,
                unit,
                system: self.units.to_string(),
            },
            error => HertzError::Quantity { option, error },
        })
    }
}

/// The steels of roller and plate: what the options say, what their grades have, and what is taken else. `sizes` are the
/// thicknesses of their products.
fn steels(
    args: &HertzArgs,
    reader: &UnitReader,
    sizes: [f64; 2],
) -> Result<[RuleSteel; 2], HertzError> {
    let mut grades = Grades::shipped()?;
    if let Some(file) = &args.grades {
        grades = grades.with_file(file)?;
    }
    let stress = |option, text: &Option<String>| reader.maybe(option, text, Dimension::STRESS);
    let graded = |name: &Option<String>, size: f64| -> Result<Given, HertzError> {
        let Some(name) = name else {
            return Ok(Given::default());
        };
        let steel = grades.find(name)?.in_units(reader.units, Some(size))?;
        Ok(steel.into())
    };
    let own = Given {
        youngs_modulus: stress("youngs-modulus", &args.youngs_modulus)?,
        poissons_ratio: args.poissons_ratio,
        yield_stress: stress("yield", &args.yield_stress)?,
        ultimate_strength: stress("ultimate", &args.ultimate)?,
        hardness: args.hardness,
    };
    let plates = Given {
        youngs_modulus: stress("plate-youngs-modulus", &args.plate_youngs_modulus)?,
        poissons_ratio: args.plate_poissons_ratio,
        yield_stress: stress("plate-yield", &args.plate_yield)?,
        ultimate_strength: stress("plate-ultimate", &args.plate_ultimate)?,
        hardness: args.plate_hardness,
    };
    let roller = own.or(graded(&args.steel, sizes[0])?);
    let plate = match &args.plate_steel {
        // Another steel: nothing of the roller's completes it.
        Some(_) => plates.or(graded(&args.plate_steel, sizes[1])?),
        None => plates.or(own).or(graded(&args.steel, sizes[1])?),
    };
    let modulus = STEEL_MODULUS * UnitSystem::InKipKsi.factor_to(reader.units, Dimension::STRESS);
    Ok([roller, plate].map(|given| RuleSteel {
        youngs_modulus: given.youngs_modulus.unwrap_or(modulus),
        poissons_ratio: given.poissons_ratio.unwrap_or(STEEL_POISSONS_RATIO),
        yield_stress: given.yield_stress,
        ultimate_strength: given.ultimate_strength,
        hardness: given.hardness,
        surface_hardened: args.surface_hardened,
    }))
}

fn metal(steel: &RuleSteel, body: &'static str, option: &'static str) -> Result<Metal, HertzError> {
    let yield_stress = steel
        .yield_stress
        .ok_or(HertzError::NoYield { body, option })?;
    Ok(Metal {
        youngs_modulus: steel.youngs_modulus,
        poissons_ratio: steel.poissons_ratio,
        yield_stress,
    })
}
