//! Isotropic elasticity as contact formulas need it.

use super::error::{self, DomainError};

/// Elastic constants of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    youngs_modulus: f64,
    poissons_ratio: f64,
}

impl Elastic {
    /// A body that does not deform.
    pub const RIGID: Self = Self {
        youngs_modulus: f64::INFINITY,
        poissons_ratio: 0.0,
    };

    /// Young's modulus E > 0 (stress) and Poisson's ratio ν in (-1, 0.5].
    ///
    /// # Errors
    /// [`DomainError::OutOfRange`] for either outside its range.
    pub fn new(youngs_modulus: f64, poissons_ratio: f64) -> Result<Self, DomainError> {
        Ok(Self {
            youngs_modulus: error::positive("Young's modulus", youngs_modulus)?,
            poissons_ratio: error::poissons_ratio(poissons_ratio)?,
        })
    }

    /// Young's modulus E, infinite for a rigid body.
    pub fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    /// Poisson's ratio ν.
    pub fn poissons_ratio(&self) -> f64 {
        self.poissons_ratio
    }

    /// Shear modulus G = E / 2(1 + ν).
    pub fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + self.poissons_ratio)
    }

    /// Plane-strain compliance (1 - ν²) / E (1/stress); zero for a rigid body.
    pub fn plane_strain_compliance(&self) -> f64 {
        (1.0 - self.poissons_ratio * self.poissons_ratio) / self.youngs_modulus
    }
}

/// Compliance of a contact, C_E = 1/E* (1/stress).
///
/// ```text
/// C_E = (1 - ν₁²)/E₁ + (1 - ν₂²)/E₂
/// ```
/// Equation (2-46) of the reference study; Johnson 4.2. Holds for half spaces.
///
/// # Errors
/// [`DomainError::Overflow`] where both bodies are rigid.
pub fn contact_compliance(first: Elastic, second: Elastic) -> Result<f64, DomainError> {
    let sum = first.plane_strain_compliance() + second.plane_strain_compliance();
    error::representable("compliance of the contact", sum)
}

/// Dundurs' second constant β of a pair in plane strain, in [-0.5, 0.5].
///
/// ```text
///      (1 - 2ν₁)/G₁ - (1 - 2ν₂)/G₂
/// β =  ────────────────────────────
///      2 [(1 - ν₁)/G₁ + (1 - ν₂)/G₂]
/// ```
/// Johnson 5.1. β = 0 (one steel on itself, for example) means that pressing two
/// half spaces together makes neither slip nor shear traction, whatever the friction.
///
/// # Errors
/// [`DomainError::Overflow`] where both bodies are rigid.
pub fn dundurs_beta(first: Elastic, second: Elastic) -> Result<f64, DomainError> {
    let shear =
        |body: Elastic, share: f64| (1.0 - share * body.poissons_ratio) / body.shear_modulus();
    let sum = shear(first, 1.0) + shear(second, 1.0);
    error::representable("compliance of the contact", sum)?;
    Ok(0.5 * (shear(first, 2.0) - shear(second, 2.0)) / sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rigid_bodies_have_no_contact_compliance() {
        assert!(contact_compliance(Elastic::RIGID, Elastic::RIGID).is_err());
        assert!(dundurs_beta(Elastic::RIGID, Elastic::RIGID).is_err());
    }

    #[test]
    fn dundurs_beta_changes_sign_with_the_order() {
        let steel = Elastic::new(29500.0, 0.3).unwrap();
        let iron = Elastic::new(15000.0, 0.25).unwrap();
        let forward = dundurs_beta(steel, iron).unwrap();
        assert_eq!(forward, -dundurs_beta(iron, steel).unwrap());
        assert_eq!(dundurs_beta(steel, steel).unwrap(), 0.0);
        let on_rigid = dundurs_beta(steel, Elastic::RIGID).unwrap();
        assert!((on_rigid - 0.4 / 1.4).abs() < 1e-15);
    }
}
