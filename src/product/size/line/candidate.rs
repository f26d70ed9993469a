//! Parallel rollers of one number and diameter: how long they must be, and how they are pressed.

use super::request::LineRequest;
use crate::analytic::hertz::LineContact;
use crate::case::bearing::{Layout, LineGeometry, LinePlate, RollerShape};
use crate::ground::units::Dimension;
use crate::product::size::candidate::compliance;
use crate::product::size::practical::rounded_up;
use crate::product::size::{PressureSpread, SizeError};
use serde::Serialize;

/// Plates over the diameter where they are left open: what a solid roller of 200 mm has in the book, 0.3.
pub const PLATE_TO_DIAMETER: f64 = 0.3;
/// Axes of neighbours, in diameters.
const SPACING: f64 = 1.4;
/// Plates reach so many diameters beyond the outermost axes.
const BEYOND: f64 = 0.75;

/// Rollers side by side, of one diameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineCandidate {
    /// How many.
    pub rollers: usize,
    /// D.
    pub diameter: f64,
    /// Of hollow rollers.
    pub wall: Option<f64>,
    /// Distance between the axes of neighbours; 0 for a single roller.
    pub spacing: f64,
    /// Of both plates.
    pub plate: f64,
    /// L that the limit asks for under the load times its margin.
    pub required_length: f64,
    /// L, rounded up, or as it was asked for.
    pub length: f64,
    /// L over D.
    pub slenderness: f64,
    /// Hertz's p0 under the load, without margin, spread evenly.
    pub even: PressureSpread,
    /// Steel in the plates and rollers.
    pub volume: f64,
    #[serde(skip)]
    pub geometry: LineGeometry,
}

impl LineCandidate {
    /// So many `rollers` of `diameter`.
    ///
    /// # Errors
    /// Where Hertz's formulas do not apply or the bearing cannot be built.
    pub fn new(request: &LineRequest, rollers: usize, diameter: f64) -> Result<Self, SizeError> {
        let units = request.units;
        let lines = rollers as f64;
        let limit = request.limit.value * request.yield_stress;
        let compliance = compliance(request.modulus.value, request.poissons_ratio.value)?;
        let most = LineContact::at_peak_pressure(limit, 0.5 * diameter, compliance)?.line_load;
        let bears = request.load * request.margin.value / (lines * most);
        let required_length = bears + request.end.value.rounded();
        let length = (request.length).unwrap_or_else(|| rounded_up(units, required_length));
        let spacing = match rollers {
            1 => 0.0,
            _ => (request.spacing).unwrap_or_else(|| rounded_up(units, SPACING * diameter)),
        };
        let plate =
            (request.plate).unwrap_or_else(|| rounded_up(units, PLATE_TO_DIAMETER * diameter));
        let wide = spacing * (lines - 1.0) + 2.0 * BEYOND * diameter;
        let own = LinePlate {
            thickness: plate,
            plan: [wide, length],
        };
        let geometry = LineGeometry {
            rollers,
            spacing,
            roller: RollerShape {
                diameter,
                wall: request.wall.map(|share| share * diameter),
                length,
                end: request.end.value,
            },
            skew: Vec::new(),
            upper: own,
            lower: own,
            curve: None,
            alike: true,
        };
        Layout::check(&geometry).map_err(|error| SizeError::Geometry {
            diameter: units.show(diameter, Dimension::LENGTH),
            error,
        })?;
        let line_load = request.load / (lines * geometry.roller.straight());
        let pressed = LineContact::new(line_load, 0.5 * diameter, compliance)?;
        let ring = geometry.roller.cross_section();
        Ok(Self {
            rollers,
            diameter,
            wall: geometry.roller.wall,
            spacing,
            plate,
            required_length,
            length,
            slenderness: length / diameter,
            even: PressureSpread {
                line_load,
                pressure: pressed.peak_pressure,
                utilisation: pressed.peak_pressure / limit,
            },
            volume: length * (lines * ring + 2.0 * plate * wide),
            geometry,
        })
    }

    /// Is it as long as the limit asks for?
    pub fn is_long_enough(&self) -> bool {
        self.length >= self.required_length * (1.0 - 1e-9)
    }
}
