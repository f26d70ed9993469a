//! Limit load of a flat punch.

use std::f64::consts::PI;

use crate::analytic::error::{self, DomainError};

/// Mean pressure at which a rigid flat punch sinks into a perfectly plastic half plane.
///
/// ```text
/// p = (2 + π) k,  k = Y/√3 (Mises):  2.9685 Y
/// ```
/// Prandtl 1920; Hill, *The Mathematical Theory of Plasticity*, 1950, ch. IX. Plane strain, no
/// hardening, friction without influence.
///
/// # Errors
/// [`DomainError::OutOfRange`] for Y not positive.
pub fn punch_pressure(yield_stress: f64) -> Result<f64, DomainError> {
    let k = error::positive("yield stress", yield_stress)? / 3f64.sqrt();
    error::representable("limit pressure", (2.0 + PI) * k)
}
