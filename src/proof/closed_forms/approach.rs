//! Approach of bodies in line contact, which needs a datum on each body.
//!
//! A line load displaces a half plane by an infinite amount: only differences between named
//! points are defined. All are compressions, positive where the distance shrinks.

use std::f64::consts::PI;

use crate::analytic::elastic::Elastic;
use crate::analytic::error::{self, DomainError};
use crate::analytic::hertz::LineContact;

/// Compression of half a solid cylinder, from the contact to the mid-plane.
///
/// ```text
/// δ = w(1 - ν²)/πE [2 ln(4R/a) - 1]
/// ```
/// Johnson (5.57): a cylinder of radius R squeezed by two opposed Hertz pressures of half width
/// a, in plane strain. The mid-plane is the plane of symmetry (u = 0, no shear). 0.04 % (a/R =
/// 0.01) to 0.7 % (0.2) below the exact series of the disc,
/// [`Ring::solid`](crate::analytic::ring::Ring::solid).
///
/// `radius` is that of the cylinder itself, not the effective one.
///
/// # Errors
/// [`DomainError::OutOfRange`] for R not positive, or the contact's half width above R/4.
pub fn half_cylinder(
    contact: &LineContact,
    radius: f64,
    body: Elastic,
) -> Result<f64, DomainError> {
    let r = error::positive("radius of the cylinder", radius)?;
    let a = contact.half_width;
    error::require(
        "half width of the contact",
        a,
        a <= 0.25 * r,
        "at most a quarter radius",
    )?;
    let unit = contact.line_load * body.plane_strain_compliance() / PI;
    Ok(unit * (2.0 * (4.0 * r / a).ln() - 1.0))
}
