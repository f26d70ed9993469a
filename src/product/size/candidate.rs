//! One diameter: what the rules make of it.
//!
//! | what | rule |
//! |---|---|
//! | initial length L | (2-50), with both constants |
//! | final length L' | (2-51), L + 2 D_r |
//! | slope of the V | (2-39) |
//! | wall | a quarter of the diameter, section 2.6.2 |
//! | plates | no rule but "larger than the wall"; 4/3 of it, as in section 2.6.2 and prototype 1 |
//! | L' of a displaced roller | statics, not in the study: see [`Request::rule`](super::Request) |

use super::SizeError;
use super::practical::rounded_up;
use super::request::{LengthRule, Request};
use crate::analytic::displaced::DisplacedRoller;
use crate::analytic::hertz::LineContact;
use crate::analytic::rolling::{largest_slope, restoring_force, rolling_friction};
use crate::analytic::sizing::{
    Constants, PRESSURE_LIMIT, PRINTED, equivalent_modulus, exact, final_length,
};
use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::case::bearing::{BearingGeometry, RollerShape};
use crate::ground::units::Dimension;
use serde::Serialize;

/// Plates over the wall: 1 in over 0.75 in in section 2.6.2 and in prototype 1. Prototype 2 has
/// 1.11, the case study of chapter 5 has 1.
pub const PLATE_TO_WALL: f64 = 4.0 / 3.0;

/// L' over D beyond which rollers are too slender for statics to tell where they press: in runs of
/// this program a bearing of 2.2 diameters is pressed 8 % harder at the crossing of its rollers than
/// statics say at the end, one of 2.0 and shorter less hard.
pub const STOUT: f64 = 2.0;

/// The largest L' over D of the study's own bearings: 17 in over 4.5 in, prototype 1.
pub const SLENDEREST: f64 = 17.0 / 4.5;

/// (2-50) and (2-51) with one constant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Lengths {
    /// c of (2-50), for the limit that is asked for.
    pub constant: f64,
    /// D L that the load asks for.
    pub diameter_times_length: f64,
    /// L.
    pub initial: f64,
    /// L' = L + 2 D_r.
    pub final_length: f64,
}

/// A contact line under an assumed distribution of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PressureSpread {
    pub line_load: f64,
    /// Hertz's p0.
    pub pressure: f64,
    /// Over the limit.
    pub utilisation: f64,
}

/// A bearing with rollers of one diameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Candidate {
    pub diameter: f64,
    pub wall: f64,
    /// Of all three plates; of the intermediate one where its valleys cross.
    pub plate: f64,
    pub printed: Lengths,
    pub exact: Lengths,
    /// L' for the load of a displaced roller, spread linearly.
    pub eccentric_length: f64,
    /// Distance of the resultant from mid-length of the roller at its outer plate.
    pub eccentricity: f64,
    /// L' that the rule asks for.
    pub required_length: f64,
    /// L', rounded up, or as it was asked for.
    pub length: f64,
    /// L' over D.
    pub slenderness: f64,
    /// (2-49) under the load, without margin, over L = L' - 2 D_r.
    pub even: PressureSpread,
    /// The same under the linear load of a displaced roller; none where the load passes its end.
    pub linear: Option<PressureSpread>,
    /// (2-3).
    pub rolling_friction: f64,
    /// (2-39), radians.
    pub largest_slope: f64,
    /// (2-28), over the weight carried.
    pub restoring_force: f64,
    /// Steel in the plates and rollers.
    pub volume: f64,
    #[serde(skip)]
    pub geometry: BearingGeometry,
}

impl Candidate {
    /// The bearing with rollers of `diameter`.
    ///
    /// # Errors
    /// Where a rule does not apply or the bearing cannot be built.
    pub fn new(request: &Request, diameter: f64) -> Result<Self, SizeError> {
        let units = request.units;
        let contact = RollerContact::new(request, diameter)?;
        let wall = if request.wall.given {
            request.wall.value * diameter
        } else {
            rounded_up(units, request.wall.value * diameter)
        };
        let plate = match request.plate {
            Some(plate) => plate,
            None => rounded_up(units, PLATE_TO_WALL * wall),
        };
        let mut geometry = BearingGeometry {
            roller: RollerShape {
                diameter,
                wall: Some(wall),
                length: 0.0,
                end: request.end.value,
            },
            slope: request.slope.value,
            offset: request.roller_displacement(),
            intermediate_thickness: plate,
            upper_thickness: plate,
            lower_thickness: plate,
            plan: [0.0; 2],
            skew: [0.0; 2],
        };
        let printed = contact.lengths(PRINTED)?;
        let exact = contact.lengths(exact())?;
        let eccentricity = eccentricity(&geometry);
        let load = request.load * request.margin.value;
        let eccentric_length = DisplacedRoller::length_for(load, eccentricity, contact.largest)?;
        let bears = match request.rule.value {
            LengthRule::Printed => printed.final_length,
            LengthRule::Exact => exact.final_length,
            LengthRule::Eccentric => eccentric_length.max(exact.final_length),
        };
        let required_length = bears + geometry.roller.end.rounded();
        let rounded = || rounded_up(units, required_length);
        let length = request.length.unwrap_or_else(rounded);
        geometry.roller.length = length;
        geometry.plan = [length; 2];
        check(&geometry, request)?;
        let straight = geometry.roller.straight();
        let friction = rolling_friction(request.rolling_lever.value, 0.5 * diameter)?;
        Ok(Self {
            diameter,
            wall,
            plate,
            printed,
            exact,
            eccentric_length,
            eccentricity,
            required_length,
            length,
            slenderness: length / diameter,
            even: contact.pressed(request.load / (straight - request.capacity))?,
            linear: match DisplacedRoller::new(request.load, straight, eccentricity) {
                Ok(roller) => Some(contact.pressed(roller.linear().largest)?),
                Err(_) => None,
            },
            rolling_friction: friction,
            largest_slope: largest_slope(request.friction.value, friction)?,
            restoring_force: restoring_force(request.slope.value)?,
            volume: volume(&geometry),
            geometry,
        })
    }

    /// Is it as long as the rule asks for?
    pub fn is_long_enough(&self) -> bool {
        self.length >= self.required_length * (1.0 - 1e-9)
    }

    /// Does it roll without sliding, (2-39)?
    pub fn rolls(&self) -> bool {
        self.geometry.slope <= self.largest_slope
    }
}

/// The diameter of a roller that is as long as it is thick and meets (2-50) with the exact constant.
///
/// # Errors
/// Where the rule does not apply.
pub fn square_diameter(request: &Request) -> Result<f64, DomainError> {
    // D L is the same for every diameter.
    let lengths = RollerContact::new(request, 1.0)?.lengths(exact())?;
    Ok(lengths.diameter_times_length.sqrt())
}

/// Contact of a roller with a plate of the same steel.
struct RollerContact<'r> {
    request: &'r Request,
    diameter: f64,
    compliance: f64,
    /// Load per length at which p0 is at its limit.
    largest: f64,
}

impl<'r> RollerContact<'r> {
    fn new(request: &'r Request, diameter: f64) -> Result<Self, DomainError> {
        let compliance = compliance(request.modulus.value, request.poissons_ratio.value)?;
        let limit = request.limit.value * request.yield_stress;
        let at_limit = LineContact::at_peak_pressure(limit, 0.5 * diameter, compliance)?;
        Ok(Self {
            request,
            diameter,
            compliance,
            largest: at_limit.line_load,
        })
    }

    /// (2-50) and (2-51). The constants hold for 1.65 times yield and go with the square of that.
    fn lengths(&self, constants: Constants) -> Result<Lengths, DomainError> {
        let request = self.request;
        let own = Constants {
            sizing: constants.sizing * (request.limit.value / PRESSURE_LIMIT).powi(2),
            ..constants
        };
        let margin = match request.rule.value {
            // The margin is for what statics do not see; the study's rules are asked as they are.
            LengthRule::Eccentric => 1.0,
            LengthRule::Printed | LengthRule::Exact => request.margin.value,
        };
        let product = own.required_diameter_times_length(
            request.load * margin,
            equivalent_modulus(self.compliance)?,
            request.yield_stress,
        )?;
        let initial = product / self.diameter;
        Ok(Lengths {
            constant: own.sizing,
            diameter_times_length: product,
            initial,
            final_length: final_length(initial, request.roller_displacement())?,
        })
    }

    fn pressed(&self, line_load: f64) -> Result<PressureSpread, DomainError> {
        let contact = LineContact::new(line_load, 0.5 * self.diameter, self.compliance)?;
        let limit = self.request.limit.value * self.request.yield_stress;
        Ok(PressureSpread {
            line_load,
            pressure: contact.peak_pressure,
            utilisation: contact.peak_pressure / limit,
        })
    }
}

/// C_E of rollers and plates of the same steel.
pub fn compliance(modulus: f64, poissons_ratio: f64) -> Result<f64, DomainError> {
    let steel = Elastic::new(modulus, poissons_ratio)?;
    contact_compliance(steel, steel)
}

/// Where the load passes the outer end of a displaced roller, from its mid-length.
///
/// At each roller the load leans by half the slope, so that its normal and its line on the slope
/// share it (that is what (2-38) rests on). It passes the crossing of the rollers at s along both
/// axes, and climbs from one outer plate to the other: s + 2 z tan(θ/2) at the farther one, the
/// inner faces of the outer plates being at ±z.
fn eccentricity(geometry: &BearingGeometry) -> f64 {
    if geometry.is_centred() {
        0.0
    } else {
        geometry.offset + 2.0 * geometry.flat_face() * (0.5 * geometry.slope).tan()
    }
}

/// Of two hollow cylinders and three plates, the middle one thicker towards its edges.
fn volume(geometry: &BearingGeometry) -> f64 {
    let ring = geometry.roller.cross_section();
    let plan = geometry.plan[0] * geometry.plan[1];
    let wedge = 0.25 * (geometry.plan[0] + geometry.plan[1]) * geometry.slope.tan();
    let plates =
        geometry.upper_thickness + geometry.intermediate_thickness + geometry.lower_thickness;
    2.0 * ring * geometry.roller.length + plan * (plates + wedge)
}

fn check(geometry: &BearingGeometry, request: &Request) -> Result<(), SizeError> {
    geometry.check().map_err(|error| SizeError::Geometry {
        diameter: request
            .units
            .show(geometry.roller.diameter, Dimension::LENGTH),
        error,
    })
}
