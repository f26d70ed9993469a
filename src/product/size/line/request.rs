//! What is asked for of parallel rollers, in one system of units.

use crate::analytic::sizing::PRESSURE_LIMIT;
use crate::case::bearing::{MOST_ROLLERS, Preset, RollerEnd};
use crate::ground::units::UnitSystem;
use crate::product::size::{Request, Setting, SizeError};

/// For what an even load does not see: ends that bulge leave a hundredth or three more to the middle, and of
/// several rollers those below the middle of a plate take more than those at its edge.
const MARGIN: f64 = 1.1;

/// Parallel rollers to size, in the units of `units`.
#[derive(Debug, Clone, PartialEq)]
pub struct LineRequest {
    pub units: UnitSystem,
    /// P, on the bearing.
    pub load: f64,
    /// σ_y, of rollers and plates.
    pub yield_stress: f64,
    pub modulus: Setting<f64>,
    pub poissons_ratio: Setting<f64>,
    /// E_t, slope of the stress-strain line beyond yield.
    pub tangent_modulus: Setting<f64>,
    /// Coulomb's coefficient.
    pub friction: Setting<f64>,
    /// How many rollers, where that is fixed; otherwise as few as will do.
    pub rollers: Option<usize>,
    /// D where it is fixed.
    pub diameter: Option<f64>,
    /// L where it is fixed.
    pub length: Option<f64>,
    /// Distance between the axes of neighbours where it is fixed.
    pub spacing: Option<f64>,
    /// Wall over diameter; `None` for solid rollers.
    pub wall: Option<f64>,
    /// Thickness of both plates where it is fixed.
    pub plate: Option<f64>,
    pub end: Setting<RollerEnd>,
    /// Allowed contact pressure over the yield stress.
    pub limit: Setting<f64>,
    /// The limit is asked of the load times this.
    pub margin: Setting<f64>,
    pub preset: Setting<Preset>,
}

impl LineRequest {
    /// A request with the defaults for all that is left open.
    pub fn new(units: UnitSystem, load: f64, yield_stress: f64) -> Self {
        let own = Request::new(units, load, yield_stress, 0.0);
        Self {
            units,
            load,
            yield_stress,
            modulus: own.modulus,
            poissons_ratio: own.poissons_ratio,
            tangent_modulus: own.tangent_modulus,
            friction: own.friction,
            rollers: None,
            diameter: None,
            length: None,
            spacing: None,
            wall: None,
            plate: None,
            end: own.end,
            limit: Setting::or(None, PRESSURE_LIMIT),
            margin: Setting::or(None, MARGIN),
            preset: Setting::or(None, Preset::Auto),
        }
    }

    /// Refuses what no bearing can have, by the name of the option.
    ///
    /// # Errors
    /// [`SizeError::Range`].
    pub fn check(&self) -> Result<(), SizeError> {
        // What both templates ask has the same ranges.
        let shared = Request {
            modulus: self.modulus,
            poissons_ratio: self.poissons_ratio,
            tangent_modulus: self.tangent_modulus,
            friction: self.friction,
            diameter: self.diameter,
            length: self.length,
            plate: self.plate,
            limit: self.limit,
            margin: self.margin,
            ..Request::new(self.units, self.load, self.yield_stress, 0.0)
        };
        shared.check()?;
        let rollers = self.rollers.unwrap_or(1);
        if !(1..=MOST_ROLLERS).contains(&rollers) {
            return Err(SizeError::Range {
                option: "--rollers",
                value: rollers.to_string(),
                range: "from 1 to 12",
            });
        }
        match self.wall {
            Some(wall) if !(0.01..=0.49).contains(&wall) => Err(SizeError::Range {
                option: "--wall",
                value: wall.to_string(),
                range: "from 0.01 to 0.49 (a share of the diameter), or left out for solid rollers",
            }),
            _ => Ok(()),
        }
    }
}
