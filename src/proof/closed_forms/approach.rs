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

/// Motion of the surface centre of a block towards a point at the depth d ≥ 0 on the axis, in plane strain, by the
/// integral of the exact strain along the axis. In a finite block the difference near the contact only, never the motion
/// against a clamped base.
///
/// ```text
/// δ = (a p0/E) [(1 - ν²) t - ½ ν(1 + ν)(1 - e^(-2t))],   sinh t = d/a
/// ```
/// From ε_z = [(1 - ν²) σ_z - ν(1 + ν) σ_x]/E with the stresses on the axis, Johnson 4.2(c). For d ≫ a it is
/// w(1 - ν²)/πE [2 ln(2d/a) - ν/(1 - ν)], Johnson (5.58): at d = 50 a but for 0.003 %.
///
/// # Errors
/// [`DomainError::OutOfRange`] for d negative or not finite.
pub fn block(contact: &LineContact, depth: f64, body: Elastic) -> Result<f64, DomainError> {
    let d = error::non_negative("depth of the datum", depth)?;
    let t = (d / contact.half_width).asinh();
    let nu = body.poissons_ratio();
    let soft = contact.half_width * contact.peak_pressure / body.youngs_modulus();
    Ok(soft * ((1.0 - nu * nu) * t + 0.5 * nu * (1.0 + nu) * (-2.0 * t).exp_m1()))
}
