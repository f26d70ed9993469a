//! Hertz contact: line, point and elliptic.
//!
//! Common assumptions: smooth elastic half spaces, no friction, contact small against the radii
//! and the thickness of the bodies. `compliance` is C_E = 1/E* of
//! [`contact_compliance`](super::contact_compliance).

mod elliptic;
mod line;
mod point;

pub use elliptic::EllipticContact;
pub use line::LineContact;
pub use point::PointContact;

use super::error::{self, DomainError};

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

/// Semi-elliptic pressure at a distance in units of the contact's half axis.
fn semi_elliptic(peak: f64, distance: f64) -> Result<f64, DomainError> {
    let known = !distance.is_nan();
    error::require("distance from the centre", distance, known, "a number")?;
    Ok(peak * (1.0 - distance * distance).max(0.0).sqrt())
}
