//! First yield below a line contact (Mises).

use super::LineField;
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;

/// Peak pressure of a line contact at which the body first yields.
///
/// ```text
/// p_Y = Y / (max Mises / p0)        ν = 0.3: 1.7937 Y
/// ```
/// Plane strain; with full sliding at the coefficient μ ≥ 0. Johnson 6.1 gives 1.67 Y for Tresca.
///
/// # Errors
/// [`DomainError::OutOfRange`] for Y not positive, ν outside (-1, 0.5] or μ negative.
pub fn line_yield_pressure(
    yield_stress: f64,
    poissons_ratio: f64,
    friction: f64,
) -> Result<f64, DomainError> {
    let y = error::positive("yield stress", yield_stress)?;
    let field = LineField::new(1.0, 1.0, poissons_ratio)?.sliding(friction)?;
    error::representable("pressure at first yield", y / field.peak_mises().value)
}

/// Line contact at first yield, without friction: w_Y = π R C_E p_Y².
///
/// # Errors
/// [`DomainError::OutOfRange`] for R, C_E or Y not positive, or ν outside (-1, 0.5].
pub fn line_yield_contact(
    yield_stress: f64,
    poissons_ratio: f64,
    radius: f64,
    compliance: f64,
) -> Result<LineContact, DomainError> {
    let peak = line_yield_pressure(yield_stress, poissons_ratio, 0.0)?;
    LineContact::at_peak_pressure(peak, radius, compliance)
}
