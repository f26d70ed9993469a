//! A roller in a V groove: it rests on two lines, one on each slope.

use std::f64::consts::PI;

use super::error::{self, DomainError};
use super::hertz::LineContact;

/// A roller of radius R lying in a groove whose sides fall towards the root at the slope θ,
/// loaded with w per length along the bisector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VGroove {
    line_load: f64,
    radius: f64,
    slope: f64,
    compliance: f64,
}

/// The two lines as they act on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interaction {
    /// Peak pressure of each line.
    pub peak_pressure: f64,
    /// Distance of each line from the plane of symmetry.
    pub offset: f64,
}

impl VGroove {
    /// Load per length w (on both lines together), radius R of the roller, slope θ in radians in
    /// (0, π/2), compliance C_E.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument outside its range.
    pub fn new(
        line_load: f64,
        radius: f64,
        slope: f64,
        compliance: f64,
    ) -> Result<Self, DomainError> {
        let steep = 0.5 * PI;
        let allowed = slope > 0.0 && slope < steep;
        let between = "above 0 and below 1.5708 rad, 90 degrees";
        Ok(Self {
            line_load: error::positive("load per length", line_load)?,
            radius: error::positive("radius", radius)?,
            slope: error::require("slope, in rad,", slope, allowed, between)?,
            compliance: error::positive("compliance of the contact", compliance)?,
        })
    }

    /// Force per length across each line without friction, N = w / 2 cos θ.
    ///
    /// Statics.
    pub fn normal_load(&self) -> f64 {
        0.5 * self.line_load / self.slope.cos()
    }

    /// The smallest and largest force across each line that friction of coefficient μ permits.
    ///
    /// ```text
    /// w / 2(cos θ + μ sin θ) ≤ N ≤ w / 2(cos θ - μ sin θ)
    /// ```
    /// The upper end belongs to a roller drawn out of the groove, the lower to one pushed in.
    /// Where μ reaches cot θ the roller jams and there is no upper bound.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for μ negative or not below cot θ.
    pub fn normal_load_bounds(&self, friction: f64) -> Result<[f64; 2], DomainError> {
        let mu = error::friction(friction)?;
        let (sin, cos) = self.slope.sin_cos();
        let limit = "below the cotangent of the slope (the roller jams)";
        error::require("coefficient of friction", mu, mu * sin < cos, limit)?;
        let half = 0.5 * self.line_load;
        Ok([half / (cos + mu * sin), half / (cos - mu * sin)])
    }

    /// Distance of each line from the plane of symmetry, R sin θ, in the rigid geometry.
    pub fn offset(&self) -> f64 {
        self.radius * self.slope.sin()
    }

    /// Gap between the roller and the root of the groove, R (1/cos θ - 1).
    pub fn gap_at_root(&self) -> f64 {
        // 1/cos θ - 1 = tan θ tan(θ/2), which does not cancel.
        self.radius * self.slope.tan() * (0.5 * self.slope).tan()
    }

    /// Hertz contact on each line, as if the other were not there: the peak pressure is
    /// 1/√(2 cos θ) of that on a single flat line.
    ///
    /// # Errors
    /// [`DomainError::Overflow`] where the result leaves the floating-point range.
    pub fn contact(&self) -> Result<LineContact, DomainError> {
        LineContact::new(self.normal_load(), self.radius, self.compliance)
    }

    /// Each line as the other one tilts and bends the surfaces under it.
    ///
    /// At the distance s = 2 R sin θ from a line load N on an elastic half plane both surfaces
    /// together turn by 2 N C_E / πs and curve by 2 N C_E / πs²:
    /// ```text
    /// p0 = √(N / π R' C_E),  1/R' = 1/R + 2 N C_E / πs²        offset = R (sin θ + 2 N C_E / πs)
    /// ```
    /// First order, from Flamant's surface displacement (Johnson 2.19). Against a boundary-element
    /// solution of the two lines on a half plane: p0 within 0.03 % for slopes of 2 to 6 degrees.
    /// Asks for contacts that stay apart, 2a ≤ R sin θ.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] where the contacts come closer than that.
    pub fn interaction(&self) -> Result<Interaction, DomainError> {
        let alone = self.contact()?;
        let apart = alone.width() <= self.offset();
        let allowed = "at most R sin θ, for two separate lines";
        error::require("contact width of each line", alone.width(), apart, allowed)?;
        let s = 2.0 * self.offset();
        let turn = 2.0 * self.normal_load() * self.compliance / (PI * s);
        let radius = (1.0 / self.radius + turn / s).recip();
        let contact = LineContact::new(self.normal_load(), radius, self.compliance)?;
        Ok(Interaction {
            peak_pressure: contact.peak_pressure,
            offset: self.offset() + self.radius * turn,
        })
    }

    /// A roller displaced from the root rests on one slope, without friction with N = w / cos θ;
    /// the second value is the horizontal force per length w tan θ that others must react.
    pub fn on_one_slope(&self) -> [f64; 2] {
        [
            self.line_load / self.slope.cos(),
            self.line_load * self.slope.tan(),
        ]
    }

    /// The horizontal force per length of such a roller where friction holds it, on the flat face opposite as on the slope: nothing
    /// else acts on it, so the forces of both lie on the line through both lines of touch, θ/2 off the vertical, and this is
    /// w tan θ/2. The force normal to the slope is w. It takes a coefficient of friction of tan θ/2 at least.
    pub fn rolling_push(&self) -> f64 {
        self.line_load * (0.5 * self.slope).tan()
    }
}
