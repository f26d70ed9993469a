//! Elliptic contact.

use std::f64::consts::PI;

use crate::analytic::elliptic_integrals::{SMALLEST_MODULUS, rd, rf};
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::semi_elliptic;
use crate::analytic::search::bisect;

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
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a distance that is not a number.
    pub fn pressure(&self, x: f64, y: f64) -> Result<f64, DomainError> {
        semi_elliptic(
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
