//! Line contact.

use std::f64::consts::PI;

use super::pressure::semi_elliptic;
use crate::analytic::error::{self, DomainError};

/// A cylinder pressed on a flat, or two parallel cylinders: contact over a long strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    /// Load per length w.
    pub line_load: f64,
    /// Effective radius R.
    pub radius: f64,
    /// Compliance C_E.
    pub compliance: f64,
    /// Half the contact width, a.
    pub half_width: f64,
    /// Largest pressure p0, on the centre line.
    pub peak_pressure: f64,
}

impl LineContact {
    /// Contact under the load per length w.
    ///
    /// ```text
    /// a = √(4 w R C_E / π)        p0 = 2w/πa = √(w / π R C_E)
    /// ```
    /// Johnson (4.43) and (4.45). Plane strain; the approach of the bodies is not defined by the
    /// contact alone, see [`approach`](crate::proof::closed_forms::approach).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive and finite.
    pub fn new(line_load: f64, radius: f64, compliance: f64) -> Result<Self, DomainError> {
        let w = error::positive("load per length", line_load)?;
        let r = error::positive("effective radius", radius)?;
        let c = error::positive("compliance of the contact", compliance)?;
        let half_width = error::representable("contact width", (4.0 * w * r * c / PI).sqrt())?;
        let peak = error::representable("peak pressure", 2.0 * w / (PI * half_width))?;
        Ok(Self {
            line_load,
            radius,
            compliance,
            half_width,
            peak_pressure: peak,
        })
    }

    /// Contact that reaches the peak pressure p0: w = π R C_E p0².
    ///
    /// Johnson (4.45), solved for w.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive and finite.
    pub fn at_peak_pressure(
        peak_pressure: f64,
        radius: f64,
        compliance: f64,
    ) -> Result<Self, DomainError> {
        let p0 = error::positive("peak pressure", peak_pressure)?;
        let r = error::positive("effective radius", radius)?;
        let c = error::positive("compliance of the contact", compliance)?;
        let load = error::representable("load per length", PI * r * c * p0 * p0)?;
        Self::new(load, r, c)
    }

    /// Width of the strip, 2a.
    pub fn width(&self) -> f64 {
        2.0 * self.half_width
    }

    /// Mean pressure w/2a = (π/4) p0.
    pub fn mean_pressure(&self) -> f64 {
        0.25 * PI * self.peak_pressure
    }

    /// Pressure p(x) = p0 √(1 - x²/a²) at the distance x from the centre line, zero outside.
    ///
    /// Johnson (4.44).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a distance that is not a number.
    pub fn pressure(&self, x: f64) -> Result<f64, DomainError> {
        semi_elliptic(self.peak_pressure, x / self.half_width)
    }
}

/// How many times as wide as Hertz's a strip is whose elastic pressure would be p0, where steel yields at `yield_stress` Y and
/// hardens little: once where it never yields, at an infinite Y.
///
/// ```text
/// 1 + 0.285 (p0 / Y - 2)        from p0 = 2 Y on
/// ```
/// Flow begins at p0 = 1.79 Y (Johnson, section 6.1); from there the mean pressure rises towards three times Y. The line is
/// through strips of problem H, plane strain, p0 of 2.2 to 6.5 Y, hardening modulus of 0.001 to 0.008 E: within 3 %. With
/// 0.05 E strips are narrower, by a tenth at 6.5 Y.
pub fn widening_in_flow(peak_pressure: f64, yield_stress: f64) -> f64 {
    1.0 + 0.285 * (peak_pressure / yield_stress - 2.0).max(0.0)
}
