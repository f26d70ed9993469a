//! First yield below a point contact (Mises).

use crate::analytic::error::{self, DomainError};
use crate::analytic::subsurface::SphereField;

/// Peak pressure of a sphere's contact at which the body first yields on the axis.
///
/// ν = 0.3: 1.6128 Y, Johnson 6.1 rounds to 1.60 Y.
///
/// # Errors
/// [`DomainError::OutOfRange`] for Y not positive or ν outside (-1, 0.5].
pub fn sphere_yield_pressure(yield_stress: f64, poissons_ratio: f64) -> Result<f64, DomainError> {
    let y = error::positive("yield stress", yield_stress)?;
    let field = SphereField::new(1.0, 1.0, poissons_ratio)?;
    error::representable(
        "pressure at first yield",
        y / field.peak_mises_on_axis().value,
    )
}
