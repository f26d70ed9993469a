//! A sphere pressed on a rigid flat beyond yield: published fits to finite-element results.
//!
//! ω is the approach over the approach at first yield, loads and areas are over theirs at first
//! yield. Perfectly plastic (or nearly so), frictionless. The fits scatter by 3 to 5 % around one
//! another; they are no exact solutions.

use std::f64::consts::PI;

use crate::analytic::error::{self, DomainError};

/// Load and area beyond yield, over those at first yield.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flattening {
    /// P / P_c.
    pub load: f64,
    /// A / A_c.
    pub area: f64,
}

/// State at first yield of a sphere on a rigid flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Critical {
    /// Approach ω_c (a length).
    pub approach: f64,
    /// Load P_c.
    pub load: f64,
}

fn approach_ratio(omega: f64, limit: f64, allowed: &str) -> Result<f64, DomainError> {
    error::require(
        "approach over that at first yield",
        omega,
        (0.0..=limit).contains(&omega),
        allowed,
    )
}

/// Kogut and Etsion's fit, ω ≤ 110.
///
/// ```text
/// ω ≤ 1:    P = ω^1.5          A = ω
/// ω ≤ 6:    P = 1.03 ω^1.425   A = 0.93 ω^1.136
/// ω ≤ 110:  P = 1.40 ω^1.263   A = 0.94 ω^1.146
/// ```
/// Kogut and Etsion, J. Appl. Mech. 69 (2002) 657. The pieces do not quite meet (3 % at ω = 1).
///
/// # Errors
/// [`DomainError::OutOfRange`] for ω outside [0, 110].
pub fn kogut_etsion(omega: f64) -> Result<Flattening, DomainError> {
    let w = approach_ratio(omega, 110.0, "at least 0 and at most 110")?;
    let [load, area] = if w <= 1.0 {
        [w.powf(1.5), w]
    } else if w <= 6.0 {
        [1.03 * w.powf(1.425), 0.93 * w.powf(1.136)]
    } else {
        [1.40 * w.powf(1.263), 0.94 * w.powf(1.146)]
    };
    Ok(Flattening { load, area })
}

/// Jackson and Green's fit; `yield_strain` is Y C_E (Y/E* of the sphere on a rigid flat), ν that
/// of the yielding body.
///
/// ```text
/// C = 1.295 e^(0.736 ν)     B = 0.14 e^(23 Y C_E)
/// ω ≤ 1.9:  P = ω^1.5       A = ω
/// else:     P = e^(-ω^(5/12)/4) ω^1.5 + (4 H_G / C Y)(1 - e^(-ω^(5/9)/25)) ω    A = ω (ω/1.9)^B
///           H_G / Y = 2.84 [1 - e^(-0.82 (a/R)^-0.7)],   a/R = (π C Y C_E / 2) √A
/// ```
/// Jackson and Green, J. Tribology 127 (2005) 343. They fitted up to a/R of about 0.41.
///
/// # Errors
/// [`DomainError::OutOfRange`] for ω negative or a/R above 0.41, Y C_E not in (0, 0.1] or ν
/// outside (-1, 0.5].
pub fn jackson_green(
    omega: f64,
    yield_strain: f64,
    poissons_ratio: f64,
) -> Result<Flattening, DomainError> {
    let w = error::non_negative("approach over that at first yield", omega)?;
    let strain = error::positive("yield strain", yield_strain)?;
    error::require("yield strain", strain, strain <= 0.1, "at most 0.1")?;
    let c = jackson_green_pressure(poissons_ratio)?;
    if w <= 1.9 {
        return Ok(Flattening {
            load: w.powf(1.5),
            area: w,
        });
    }
    let area = w * (w / 1.9).powf(0.14 * (23.0 * strain).exp());
    let slope = 0.5 * PI * c * strain * area.sqrt();
    error::require(
        "contact radius over radius",
        slope,
        slope <= 0.41,
        "at most 0.41",
    )?;
    let hardness = -2.84 * (-0.82 * slope.powf(-0.7)).exp_m1();
    let elastic = (-0.25 * w.powf(5.0 / 12.0)).exp() * w.powf(1.5);
    let plastic = -4.0 * hardness / c * (-w.powf(5.0 / 9.0) / 25.0).exp_m1() * w;
    Ok(Flattening {
        load: elastic + plastic,
        area,
    })
}

/// p0/Y at first yield as Jackson and Green fit it, C = 1.295 e^(0.736 ν); the exact one is
/// [`sphere_yield_pressure`](super::subsurface::onset::sphere_yield_pressure).
fn jackson_green_pressure(poissons_ratio: f64) -> Result<f64, DomainError> {
    Ok(1.295 * (0.736 * error::poissons_ratio(poissons_ratio)?).exp())
}

/// First yield with the exact peak pressure p_Y on the axis, Johnson 6.1.
///
/// ```text
/// ω_c = (π p_Y C_E / 2)² R        P_c = (4/3) (R C_E)² (π p_Y / 2)³
/// ```
///
/// # Errors
/// [`DomainError::OutOfRange`] for R, C_E or Y not positive, or ν outside (-1, 0.5].
pub fn exact_critical(
    radius: f64,
    compliance: f64,
    yield_stress: f64,
    poissons_ratio: f64,
) -> Result<Critical, DomainError> {
    let peak = super::subsurface::onset::sphere_yield_pressure(yield_stress, poissons_ratio)?;
    let r = error::positive("effective radius", radius)?;
    let c = error::positive("compliance of the contact", compliance)?;
    let slope = 0.5 * PI * peak * c;
    let approach = error::representable("approach at first yield", slope * slope * r)?;
    let load = 4.0 / 3.0 * (r * slope) * (r * slope) * (0.5 * PI * peak);
    Ok(Critical {
        approach,
        load: error::representable("load at first yield", load)?,
    })
}
