//! Equations (2-45) to (2-51) of the reference study: the design rules for rollers.
//!
//! Each is there with the constants as printed and with the exact ones. The printed equations
//! rest on Hertz's line contact of a solid cylinder on a half space ([`hertz`](super::hertz)),
//! with the load spread evenly along the roller. p is the load per length, D = 2R, and the width
//! b is the *full* contact width 2a.

use std::f64::consts::{FRAC_2_SQRT_PI, PI};

use super::error::{self, DomainError};

/// Share of the yield stress that (2-49) allows for the contact pressure.
pub const PRESSURE_LIMIT: f64 = 1.65;

/// Poisson's ratio that (2-48) and (2-50) have built in.
pub const STEEL_POISSONS_RATIO: f64 = 0.3;

/// The numbers in equations (2-45), (2-47), (2-48) and (2-50).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants {
    /// In σ_c = c √(p / R C_E), (2-45).
    pub pressure: f64,
    /// In b = c √(p R C_E), (2-47).
    pub width: f64,
    /// In σ_c = c √(p E_s / R), (2-48): both bodies one steel, ν = 0.3.
    pub steel_pressure: f64,
    /// In D L ≥ P E_s / c σ_y², (2-50).
    pub sizing: f64,
}

/// As printed: 0.564, 2.263, 0.418 and 8.
///
/// 2.263 is 0.28 % high (1.60 √2, from a rounded handbook constant). 8 does not follow from
/// (2-48) and (2-49): a roller sized with exactly 8 reaches 1.673 σ_y, 1.4 % above the limit.
pub const PRINTED: Constants = Constants {
    pressure: 0.564,
    width: 2.263,
    steel_pressure: 0.418,
    sizing: 8.0,
};

/// Exact: 1/√π, 4/√π, 1/√(2π(1 - ν²)) and (1.65 / 0.41820...)²/2 = 7.7832.
pub fn exact() -> Constants {
    let nu = STEEL_POISSONS_RATIO;
    let steel_pressure = (2.0 * PI * (1.0 - nu * nu)).sqrt().recip();
    Constants {
        pressure: 0.5 * FRAC_2_SQRT_PI,
        width: 2.0 * FRAC_2_SQRT_PI,
        steel_pressure,
        sizing: 0.5 * (PRESSURE_LIMIT / steel_pressure).powi(2),
    }
}

/// Modulus E_s of the one steel (ν = 0.3) whose contact on itself has the compliance C_E, so that
/// (2-48) and (2-50) serve for any pair: E_s = 2 (1 - 0.3²) / C_E.
///
/// # Errors
/// [`DomainError::OutOfRange`] for C_E not positive.
pub fn equivalent_modulus(compliance: f64) -> Result<f64, DomainError> {
    let c = error::positive("compliance of the contact", compliance)?;
    let nu = STEEL_POISSONS_RATIO;
    error::representable("equivalent modulus", 2.0 * (1.0 - nu * nu) / c)
}

/// Whether a peak pressure keeps σ_c ≤ 1.65 σ_y, (2-49); AASHTO (2004) 14.7.1.4, a limit for the
/// service limit state.
///
/// # Errors
/// [`DomainError::OutOfRange`] for either stress not positive.
pub fn within_limit(peak_pressure: f64, yield_stress: f64) -> Result<bool, DomainError> {
    let y = error::positive("yield stress", yield_stress)?;
    Ok(error::positive("peak pressure", peak_pressure)? <= PRESSURE_LIMIT * y)
}

impl Constants {
    /// Largest contact stress σ_c = c √(p / R C_E), (2-45).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn peak_pressure(
        &self,
        line_load: f64,
        radius: f64,
        compliance: f64,
    ) -> Result<f64, DomainError> {
        let [p, r, c] = pressed(line_load, radius, compliance)?;
        error::representable("peak pressure", self.pressure * (p / r / c).sqrt())
    }

    /// Full contact width b = 2a = c √(p R C_E), (2-47).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn contact_width(
        &self,
        line_load: f64,
        radius: f64,
        compliance: f64,
    ) -> Result<f64, DomainError> {
        let [p, r, c] = pressed(line_load, radius, compliance)?;
        error::representable("contact width", self.width * (p * r * c).sqrt())
    }

    /// Largest contact stress of steel on steel, ν = 0.3: σ_c = c √(p E_s / R), (2-48).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn steel_peak_pressure(
        &self,
        line_load: f64,
        radius: f64,
        youngs_modulus: f64,
    ) -> Result<f64, DomainError> {
        let p = error::positive("load per length", line_load)?;
        let r = error::positive("radius", radius)?;
        let e = error::positive("Young's modulus", youngs_modulus)?;
        error::representable("peak pressure", self.steel_pressure * (p / r * e).sqrt())
    }

    /// Product D L that the load P needs: D L ≥ P E_s / (c σ_y²), (2-50). An area.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn required_diameter_times_length(
        &self,
        load: f64,
        youngs_modulus: f64,
        yield_stress: f64,
    ) -> Result<f64, DomainError> {
        let p = error::positive("load", load)?;
        let e = error::positive("Young's modulus", youngs_modulus)?;
        let y = error::positive("yield stress", yield_stress)?;
        error::representable("required D L", p / y * e / y / self.sizing)
    }

    /// Load P that a roller of diameter D and (effective) length L may carry: (2-50) solved for P.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for an argument that is not positive.
    pub fn load_capacity(
        &self,
        diameter: f64,
        length: f64,
        youngs_modulus: f64,
        yield_stress: f64,
    ) -> Result<f64, DomainError> {
        let d = error::positive("diameter", diameter)?;
        let l = error::positive("length", length)?;
        let e = error::positive("Young's modulus", youngs_modulus)?;
        let y = error::positive("yield stress", yield_stress)?;
        error::representable("load capacity", self.sizing * d * l * (y / e) * y)
    }
}

fn pressed(line_load: f64, radius: f64, compliance: f64) -> Result<[f64; 3], DomainError> {
    Ok([
        error::positive("load per length", line_load)?,
        error::positive("radius", radius)?,
        error::positive("compliance of the contact", compliance)?,
    ])
}

/// Final length of a roller, L' = L + 2 D_r, (2-51).
///
/// `length` is the L of (2-50), `roller_displacement` D_r how far the roller travels from the
/// centre; the bearing travels twice as far.
///
/// # Errors
/// [`DomainError::OutOfRange`] for L not positive or D_r negative.
pub fn final_length(length: f64, roller_displacement: f64) -> Result<f64, DomainError> {
    let l = error::positive("length", length)?;
    Ok(l + 2.0 * error::non_negative("displacement of the roller", roller_displacement)?)
}

/// Length over which a displaced roller still bears, L = L' - 2 D_r: (2-51) the other way round.
///
/// # Errors
/// [`DomainError::OutOfRange`] for L' not positive, or D_r outside [0, L'/2).
pub fn effective_length(final_length: f64, roller_displacement: f64) -> Result<f64, DomainError> {
    let l = error::positive("length", final_length)?;
    let d = error::non_negative("displacement of the roller", roller_displacement)?;
    error::require(
        "displacement of the roller",
        d,
        2.0 * d < l,
        "less than half the length",
    )?;
    Ok(l - 2.0 * d)
}
