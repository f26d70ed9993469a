//! Hertz contact: line, point and elliptic.
//!
//! Common assumptions: smooth elastic half spaces, no friction, contact small against the radii
//! and the thickness of the bodies. `compliance` is C_E = 1/E* of
//! [`contact_compliance`](super::contact_compliance).

use std::f64::consts::PI;

use super::elliptic::{SMALLEST_MODULUS, rd, rf};
use super::error::{self, DomainError};
use super::search::bisect;

/// Effective radius R of two bodies, 1/R = 1/R₁ + 1/R₂.
///
/// A flat has an infinite radius, a hollow side (a groove) a negative one. Johnson 4.1.
///
/// # Errors
/// [`DomainError::OutOfRange`] for a radius that is zero or not a number, and
/// [`DomainError::Overflow`] where the surfaces conform (1/R not positive).
pub fn effective_radius(first: f64, second: f64) -> Result<f64, DomainError> {
    let curvature = |argument, radius: f64| {
        let allowed = !radius.is_nan() && radius != 0.0;
        error::require(argument, radius, allowed, "not zero").map(f64::recip)
    };
    let sum = curvature("radius of the first body", first)?
        + curvature("radius of the second body", second)?;
    if sum <= 0.0 {
        return Err(DomainError::Overflow {
            quantity: "effective radius",
            value: sum.recip(),
        });
    }
    error::representable("effective radius", sum.recip())
}

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
    /// contact alone, see [`approach`](super::approach).
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
    /// Johnson (4.44). NaN only where x is.
    pub fn pressure(&self, x: f64) -> f64 {
        ellipse(self.peak_pressure, x / self.half_width)
    }
}

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
    pub fn pressure(&self, r: f64) -> f64 {
        ellipse(self.peak_pressure, r / self.contact_radius)
    }
}

/// Bodies of general curvature (crossed cylinders, barrels): contact over an ellipse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticContact {
    /// Load P.
    pub load: f64,
    /// Coefficients A ≤ B of the gap A x² + B y².
    pub gap: [f64; 2],
    /// Compliance C_E.
    pub compliance: f64,
    /// Semi-axes a ≥ b, along x and y.
    pub semi_axes: [f64; 2],
    /// Largest pressure p0, in the centre.
    pub peak_pressure: f64,
    /// Approach δ of distant points of the two bodies.
    pub approach: f64,
}

impl EllipticContact {
    /// Contact under the load P of surfaces whose gap is A x² + B y².
    ///
    /// With κ = b/a, and K, E the complete integrals for m = 1 - κ²:
    /// ```text
    /// B/A = (E/κ² - K) / (K - E)               a³ = 3 P C_E (K - E) / 2π m A
    /// b = κ a        p0 = 3P / 2πab        δ = p0 C_E b K
    /// ```
    /// Johnson (4.24) to (4.32), exact. Evaluated through R_D, which needs no special case for the
    /// circle (A = B) and loses no digits for slender ellipses. Arguments in any order; B/A up
    /// to 1e20.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive and finite, or B/A > 1e20.
    pub fn new(load: f64, gap: [f64; 2], compliance: f64) -> Result<Self, DomainError> {
        let p = error::positive("load", load)?;
        let first = error::positive("gap coefficient A", gap[0])?;
        let second = error::positive("gap coefficient B", gap[1])?;
        let c = error::positive("compliance of the contact", compliance)?;
        let (small, large) = (first.min(second), first.max(second));
        let kappa = axis_ratio(large / small)?;
        let square = kappa * kappa;
        let cubed = p * c * rd(0.0, square, 1.0) / (2.0 * PI * small);
        let a = error::representable("contact semi-axis", cubed.cbrt())?;
        let b = error::representable("contact semi-axis", kappa * a)?;
        let peak = error::representable("peak pressure", 1.5 * p / (PI * a * b))?;
        let approach = error::representable("approach", peak * c * b * rf(0.0, square, 1.0))?;
        Ok(Self {
            load,
            gap: [small, large],
            compliance,
            semi_axes: [a, b],
            peak_pressure: peak,
            approach,
        })
    }

    /// Two cylinders whose axes cross at a right angle: A = 1/2R₁, B = 1/2R₂.
    ///
    /// Equal radii give the circle of a sphere of that radius on a flat.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive and finite.
    pub fn crossed_cylinders(
        load: f64,
        radii: [f64; 2],
        compliance: f64,
    ) -> Result<Self, DomainError> {
        let first = error::positive("radius of the first cylinder", radii[0])?;
        let second = error::positive("radius of the second cylinder", radii[1])?;
        Self::new(load, [0.5 / first, 0.5 / second], compliance)
    }

    /// Mean pressure (2/3) p0.
    pub fn mean_pressure(&self) -> f64 {
        self.peak_pressure * 2.0 / 3.0
    }

    /// Pressure p0 √(1 - x²/a² - y²/b²), zero outside the ellipse.
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        ellipse(
            self.peak_pressure,
            (x / self.semi_axes[0]).hypot(y / self.semi_axes[1]),
        )
    }

    /// Ratio of the axes κ = b/a, in (0, 1].
    pub fn axis_ratio(&self) -> f64 {
        self.semi_axes[1] / self.semi_axes[0]
    }
}

/// κ = b/a of the contact ellipse for the ratio B/A ≥ 1 of the gap coefficients.
fn axis_ratio(gap_ratio: f64) -> Result<f64, DomainError> {
    let allowed = (1.0..=1e20).contains(&gap_ratio);
    error::require(
        "ratio B/A of the gap coefficients",
        gap_ratio,
        allowed,
        "at most 1e20",
    )?;
    if gap_ratio == 1.0 {
        return Ok(1.0);
    }
    // B/A falls from infinity to 1 as κ rises to 1; logarithms keep the bisection even.
    let misfit = |log_kappa: f64| {
        let square = (2.0 * log_kappa).exp();
        (rd(0.0, 1.0, square) / rd(0.0, square, 1.0)).ln() - gap_ratio.ln()
    };
    Ok(bisect(misfit, SMALLEST_MODULUS.ln(), 0.0).exp())
}

fn ellipse(peak: f64, distance: f64) -> f64 {
    // `max` would turn a NaN distance into a zero pressure.
    let inside = 1.0 - distance * distance;
    if inside < 0.0 {
        0.0
    } else {
        peak * inside.sqrt()
    }
}
