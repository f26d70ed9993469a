//! Limit load of a flat punch.

use std::f64::consts::PI;

use crate::analytic::error::{self, DomainError};

/// Yield criterion that fixes the shear yield stress k.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum YieldCriterion {
    /// k = Y/√3.
    Mises,
    /// k = Y/2.
    Tresca,
}

/// Mean pressure at which a rigid flat punch sinks into a perfectly plastic half plane.
///
/// ```text
/// p = (2 + π) k        Mises: 2.9685 Y        Tresca: 2.5708 Y
/// ```
/// Prandtl 1920; Hill, *The Mathematical Theory of Plasticity*, 1950, ch. IX. Plane strain, no
/// hardening, friction without influence.
///
/// # Errors
/// [`DomainError::OutOfRange`] for Y not positive.
pub fn punch_pressure(yield_stress: f64, criterion: YieldCriterion) -> Result<f64, DomainError> {
    let y = error::positive("yield stress", yield_stress)?;
    let k = match criterion {
        YieldCriterion::Mises => y / 3f64.sqrt(),
        YieldCriterion::Tresca => 0.5 * y,
    };
    error::representable("limit pressure", (2.0 + PI) * k)
}
