//! Point contact of spheres.

use std::f64::consts::PI;

use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::semi_elliptic;

/// A sphere pressed on a flat or another sphere: contact over a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointContact {
    /// Load P.
    pub load: f64,
    /// Effective radius R.
    pub radius: f64,
    /// Compliance C_E.
    pub compliance: f64,
    /// Radius of the contact circle, a.
    pub contact_radius: f64,
    /// Largest pressure p0, in the centre.
    pub peak_pressure: f64,
    /// Approach δ of distant points of the two bodies.
    pub approach: f64,
}

impl PointContact {
    /// Contact under the load P.
    ///
    /// ```text
    /// a³ = 3 P R C_E / 4        p0 = 3P / 2πa²        δ = a²/R
    /// ```
    /// Johnson (4.22) to (4.24).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive and finite.
    pub fn new(load: f64, radius: f64, compliance: f64) -> Result<Self, DomainError> {
        let p = error::positive("load", load)?;
        let r = error::positive("effective radius", radius)?;
        let c = error::positive("compliance of the contact", compliance)?;
        let a = error::representable("contact radius", (0.75 * p * r * c).cbrt())?;
        let peak = error::representable("peak pressure", 1.5 * p / (PI * a * a))?;
        let approach = error::representable("approach", a * a / r)?;
        Ok(Self {
            load,
            radius,
            compliance,
            contact_radius: a,
            peak_pressure: peak,
            approach,
        })
    }

    /// Mean pressure (2/3) p0.
    pub fn mean_pressure(&self) -> f64 {
        self.peak_pressure * 2.0 / 3.0
    }

    /// Pressure p0 √(1 - r²/a²) at the distance r from the centre, zero outside.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a distance that is not a number.
    pub fn pressure(&self, r: f64) -> Result<f64, DomainError> {
        semi_elliptic(self.peak_pressure, r / self.contact_radius)
    }
}
