//! Rolling between slopes, sections 2.2 to 2.4 of the reference study: when a roller rolls without
//! sliding, and with what force the bearing returns.

use super::error::{self, DomainError};

/// Coefficient of rolling friction μ_r = δ / R, (2-3); δ is the distance of the contact force from
/// the roller's centre line.
///
/// # Errors
/// [`DomainError::OutOfRange`] for δ negative or R not positive.
pub fn rolling_friction(lever: f64, radius: f64) -> Result<f64, DomainError> {
    let lever = error::non_negative("lever of rolling friction", lever)?;
    Ok(lever / error::positive("radius", radius)?)
}

/// Largest slope, in radians, on which a roller rolls without sliding: θ ≤ 2 atan(μ_s - μ_r), (2-39).
/// Zero where rolling friction is the larger.
///
/// # Errors
/// [`DomainError::OutOfRange`] for a negative coefficient.
pub fn largest_slope(static_friction: f64, rolling_friction: f64) -> Result<f64, DomainError> {
    let s = error::non_negative("coefficient of static friction", static_friction)?;
    let r = error::non_negative("coefficient of rolling friction", rolling_friction)?;
    Ok(2.0 * (s - r).max(0.0).atan())
}

/// Force that returns the bearing, over the weight on it, along a principal direction: sin θ / 2,
/// (2-28).
///
/// # Errors
/// [`DomainError::OutOfRange`] for a slope that is not finite.
pub fn restoring_force(slope: f64) -> Result<f64, DomainError> {
    Ok(0.5 * error::finite("slope", slope)?.sin())
}
