//! First yield below a point or elliptic contact (Mises).

use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::{EllipticContact, PointContact};
use crate::analytic::subsurface::{EllipseField, SphereField};

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

/// Point contact at first yield: P_Y = π³ R² C_E² p_Y³ / 6. Johnson 6.1.
///
/// # Errors
/// [`DomainError::OutOfRange`] for R, C_E or Y not positive, or ν outside (-1, 0.5].
pub fn sphere_yield_contact(
    yield_stress: f64,
    poissons_ratio: f64,
    radius: f64,
    compliance: f64,
) -> Result<PointContact, DomainError> {
    let peak = sphere_yield_pressure(yield_stress, poissons_ratio)?;
    let r = error::positive("effective radius", radius)?;
    let c = error::positive("compliance of the contact", compliance)?;
    let load = std::f64::consts::PI.powi(3) * (r * c * peak).powi(2) * peak / 6.0;
    PointContact::new(error::representable("load at first yield", load)?, r, c)
}

/// The elliptic contact `contact`, its load changed until the body first yields on the axis:
/// P_Y = P (p_Y / p0)³, since the shape of the ellipse does not depend on the load.
///
/// # Errors
/// [`DomainError::OutOfRange`] for Y not positive or ν outside (-1, 0.5].
pub fn ellipse_yield_contact(
    contact: &EllipticContact,
    yield_stress: f64,
    poissons_ratio: f64,
) -> Result<EllipticContact, DomainError> {
    let y = error::positive("yield stress", yield_stress)?;
    let peak = EllipseField::below(contact, poissons_ratio)?.peak_mises_on_axis();
    let load = contact.load * (y / peak.value).powi(3);
    EllipticContact::new(
        error::representable("load at first yield", load)?,
        contact.gap,
        contact.compliance,
    )
}
