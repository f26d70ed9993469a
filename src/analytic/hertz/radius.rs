//! The radius that a contact of two round bodies feels.

use crate::analytic::error::{self, DomainError};

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
