//! Steel with a straight hardening line: the curve in a tension test.

use crate::analytic::error::{self, DomainError};

/// What the strain of the second point of a stress-strain curve means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrainMeasure {
    /// Elastic and plastic strain together, as read off a tension test.
    Total,
    /// Plastic strain alone, as in the tables of Abaqus and CalculiX.
    Plastic,
}

/// Elastic up to yield, then a straight line; isotropic hardening.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BilinearSteel {
    youngs_modulus: f64,
    yield_stress: f64,
    tangent_modulus: f64,
    hardening_modulus: f64,
}

impl BilinearSteel {
    /// E, yield stress Y and tangent modulus E_t of the hardening line in [0, E).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for E or Y not positive, or E_t outside its range.
    pub fn new(
        youngs_modulus: f64,
        yield_stress: f64,
        tangent_modulus: f64,
    ) -> Result<Self, DomainError> {
        let e = error::positive("Young's modulus", youngs_modulus)?;
        let y = error::positive("yield stress", yield_stress)?;
        let t = error::non_negative("tangent modulus", tangent_modulus)?;
        error::require("tangent modulus", t, t < e, "less than Young's modulus")?;
        let hardening_modulus = t / (1.0 - t / e);
        Ok(Self {
            youngs_modulus: e,
            yield_stress: y,
            tangent_modulus: t,
            hardening_modulus,
        })
    }

    /// Steel whose hardening line runs from yield to the point (stress, strain).
    ///
    /// ```text
    /// total strain:    E_t = (σ - Y) / (ε - Y/E)      H = E E_t / (E - E_t)
    /// plastic strain:  H = (σ - Y) / ε_p              E_t = E H / (E + H)
    /// ```
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for E or Y not positive, a stress below Y, or a strain that
    /// leaves no plastic strain.
    pub fn from_second_point(
        youngs_modulus: f64,
        yield_stress: f64,
        stress: f64,
        strain: f64,
        measure: StrainMeasure,
    ) -> Result<Self, DomainError> {
        let e = error::positive("Young's modulus", youngs_modulus)?;
        let y = error::positive("yield stress", yield_stress)?;
        let s = error::positive("stress of the second point", stress)?;
        error::require(
            "stress of the second point",
            s,
            s >= y,
            "at least the yield stress",
        )?;
        let strain = error::finite("strain of the second point", strain)?;
        let plastic = match measure {
            StrainMeasure::Total => strain - s / e,
            StrainMeasure::Plastic => strain,
        };
        let more = "more than the elastic strain there";
        error::require("strain of the second point", strain, plastic > 0.0, more)?;
        let h = (s - y) / plastic;
        Self::new(e, y, h / (1.0 + h / e))
    }

    /// Young's modulus E.
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Yield stress Y.
    pub fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Slope E_t of the hardening line over total strain.
    pub fn tangent_modulus(&self) -> f64 {
        self.tangent_modulus
    }

    /// Slope H = E E_t / (E - E_t) of the hardening line over plastic strain.
    pub fn hardening_modulus(&self) -> f64 {
        self.hardening_modulus
    }

    /// Strain at yield, Y/E.
    pub fn yield_strain(&self) -> f64 {
        self.yield_stress / self.youngs_modulus
    }

    /// Uniaxial stress at the total strain ε of monotonic loading, of the sign of ε:
    /// E ε up to yield, then Y + E_t (ε - Y/E).
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a strain that is not finite.
    pub fn stress(&self, strain: f64) -> Result<f64, DomainError> {
        let size = error::finite("strain", strain)?.abs();
        if size <= self.yield_strain() {
            return Ok(self.youngs_modulus * strain);
        }
        let stress = self.yield_stress + self.tangent_modulus * (size - self.yield_strain());
        Ok(stress.copysign(strain))
    }

    /// Strain that remains when the bar is unloaded from the total strain ε: ε - σ(ε)/E, which is
    /// the plastic strain. Isotropic hardening never yields on the way to zero stress.
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for a strain that is not finite.
    pub fn residual_strain(&self, strain: f64) -> Result<f64, DomainError> {
        let stress = self.stress(strain)?;
        let elastic = strain.abs() <= self.yield_strain();
        Ok(if elastic {
            0.0
        } else {
            strain - stress / self.youngs_modulus
        })
    }
}

/// True stress and logarithmic strain of an engineering point: σ(1 + ε), ln(1 + ε).
///
/// Uniform elongation without change of volume.
///
/// # Errors
/// [`DomainError::OutOfRange`] for a stress that is not finite or ε not above -1.
pub fn true_from_engineering(stress: f64, strain: f64) -> Result<[f64; 2], DomainError> {
    let s = error::finite("stress", stress)?;
    let e = error::require(
        "strain",
        strain,
        strain > -1.0 && strain.is_finite(),
        "above -1",
    )?;
    Ok([s * (1.0 + e), e.ln_1p()])
}
