//! The pressure of all Hertz contacts.

use crate::analytic::error::{self, DomainError};

/// Semi-elliptic pressure at a distance in units of the contact's half axis.
pub(crate) fn semi_elliptic(peak: f64, distance: f64) -> Result<f64, DomainError> {
    let known = !distance.is_nan();
    error::require("distance from the centre", distance, known, "a number")?;
    Ok(peak * (1.0 - distance * distance).max(0.0).sqrt())
}
