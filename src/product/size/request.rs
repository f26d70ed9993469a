//! What is asked for: loads, steel, displacement and limits, in one system of units.

use super::SizeError;
use crate::analytic::sizing::PRESSURE_LIMIT;
use crate::case::bearing::{Preset, RollerEnd};
use crate::ground::units::{Dimension, Quantity, UnitError, UnitSystem};
use serde::{Serialize, Serializer};

/// A value that may be left to the program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting<T> {
    pub value: T,
    /// Was it asked for (true), or is it the default?
    pub given: bool,
}

impl<T> Setting<T> {
    /// `asked`, or else the default.
    pub fn or(asked: Option<T>, default: T) -> Self {
        Self {
            given: asked.is_some(),
            value: asked.unwrap_or(default),
        }
    }
}

/// What determines the length of the rollers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LengthRule {
    /// (2-50) with the constant as printed, 8, and (2-51).
    Printed,
    /// (2-50) with the exact constant, 7.783, and (2-51).
    Exact,
    /// The longer of that and what statics ask of a displaced roller, whose load leans on one end.
    Eccentric,
}

/// A bearing to size, in the units of `units`; angles in radians.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    pub units: UnitSystem,
    /// P, on the bearing.
    pub load: f64,
    /// σ_y, of rollers and plates.
    pub yield_stress: f64,
    /// 2 D_r, displacement of the bearing; a roller travels half as far.
    pub capacity: f64,
    pub modulus: Setting<f64>,
    pub poissons_ratio: Setting<f64>,
    /// E_t, slope of the stress-strain line beyond yield.
    pub tangent_modulus: Setting<f64>,
    /// θ, of the V.
    pub slope: Setting<f64>,
    /// μ_s, Coulomb's coefficient.
    pub friction: Setting<f64>,
    /// δ of (2-3).
    pub rolling_lever: Setting<f64>,
    /// D where it is fixed; otherwise a series is tried.
    pub diameter: Option<f64>,
    /// L' where it is fixed.
    pub length: Option<f64>,
    /// Wall of the rollers over their diameter.
    pub wall: Setting<f64>,
    /// Thickness of all three plates where it is fixed.
    pub plate: Option<f64>,
    pub end: Setting<RollerEnd>,
    /// Allowed contact pressure over the yield stress.
    pub limit: Setting<f64>,
    pub rule: Setting<LengthRule>,
    /// The rule is asked of the load times this.
    pub margin: Setting<f64>,
    pub preset: Setting<Preset>,
}

/// Wall over diameter: section 2.6.2, which asks for a finite-element analysis below it.
const WALL: f64 = 0.25;

/// For what statics do not see: the ring and the plates bend, and ends press harder. With it, seven
/// bearings (20 to 1485 kip, 50 to 240 ksi, 2 to 8 in of capacity), solved by this program on `h0125`,
/// kept p0 within 84 % of its limit and the elastic Mises stress within 91 % of yield, away from edges.
/// With 1.25, one of four exceeded yield (400 kip, 240 ksi, 6 in: 105 %, less than its error).
pub const ECCENTRIC_MARGIN: f64 = 1.4;

impl Request {
    /// A request with the defaults of the reference study for all that is left open.
    pub fn new(units: UnitSystem, load: f64, yield_stress: f64, capacity: f64) -> Self {
        // Constants of the program: they do read.
        let known = |text: &str, dimension| quantity(text, units, dimension).unwrap_or(f64::NAN);
        let modulus = known("29500 ksi", Dimension::STRESS);
        let open = |value| Setting {
            value,
            given: false,
        };
        Self {
            units,
            load,
            yield_stress,
            capacity,
            modulus: open(modulus),
            poissons_ratio: open(0.3),
            tangent_modulus: open(modulus / 100.0),
            slope: open(4f64.to_radians()),
            friction: open(0.1),
            rolling_lever: open(known("0.002 in", Dimension::LENGTH)),
            diameter: None,
            length: None,
            wall: open(WALL),
            plate: None,
            end: Setting::or(None, RollerEnd::Square),
            limit: open(PRESSURE_LIMIT),
            rule: Setting::or(None, LengthRule::Eccentric),
            margin: open(ECCENTRIC_MARGIN),
            preset: Setting::or(None, Preset::H0125),
        }
    }

    /// D_r = s, how far a roller travels.
    pub fn roller_displacement(&self) -> f64 {
        0.5 * self.capacity
    }

    /// Refuses what no bearing can have, by the name of the option.
    ///
    /// # Errors
    /// [`SizeError::Range`].
    pub fn check(&self) -> Result<(), SizeError> {
        let positive = |option, value| (option, value, "more than 0", value > 0.0);
        let not_negative = |option, value| (option, value, "0 or more", value >= 0.0);
        let pairs = [
            positive("--load", self.load),
            positive("--yield", self.yield_stress),
            not_negative("--capacity", self.capacity),
            positive("--modulus", self.modulus.value),
            (
                "--poisson",
                self.poissons_ratio.value,
                "from 0 to less than 0.5",
                (0.0..0.5).contains(&self.poissons_ratio.value),
            ),
            (
                "--tangent-modulus",
                self.tangent_modulus.value,
                "from 0 to less than the modulus",
                (0.0..self.modulus.value).contains(&self.tangent_modulus.value),
            ),
            not_negative("--friction", self.friction.value),
            not_negative("--rolling-lever", self.rolling_lever.value),
            positive("--diameter", self.diameter.unwrap_or(1.0)),
            (
                "--length",
                self.length.unwrap_or(1.0),
                "more than the capacity",
                self.length.is_none_or(|l| l > self.capacity && l > 0.0),
            ),
            (
                "--wall",
                self.wall.value,
                "from 0.01 to 0.49 (a share of the diameter)",
                (0.01..=0.49).contains(&self.wall.value),
            ),
            positive("--plate", self.plate.unwrap_or(1.0)),
            positive("--limit", self.limit.value),
            (
                "--margin",
                self.margin.value,
                "1 or more",
                self.margin.value >= 1.0,
            ),
        ];
        for (option, value, range, met) in pairs {
            if !(met && value.is_finite()) {
                return Err(SizeError::Range {
                    option,
                    value: value.to_string(),
                    range,
                });
            }
        }
        let slope = self.slope.value.to_degrees();
        if (0.05..45.0).contains(&slope) {
            Ok(())
        } else {
            Err(SizeError::Range {
                option: "--slope",
                value: format!("{slope} deg"),
                range: "from 0.05 to less than 45 deg",
            })
        }
    }
}

/// The number of the quantity `text` in `units`.
///
/// # Errors
/// Where it is none, or measures something else.
pub fn quantity(text: &str, units: UnitSystem, dimension: Dimension) -> Result<f64, UnitError> {
    Quantity::parse(text)?.value_in(units, dimension)
}

/// The system of units in which people who give a load in `text` think; `None` where it has no unit
/// of force that is known.
pub fn units_of_load(text: &str) -> Option<UnitSystem> {
    let quantity = Quantity::parse(text).ok()?;
    if quantity.dimension() != Dimension::FORCE {
        return None;
    }
    if text.contains("kip") || text.contains("lbf") {
        Some(UnitSystem::InKipKsi)
    } else {
        Some(UnitSystem::MmNMPa)
    }
}

impl<T: Serialize> Serialize for Setting<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.value.serialize(serializer)
    }
}
