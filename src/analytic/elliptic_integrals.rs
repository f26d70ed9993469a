//! Elliptic integrals of Legendre's form, by Carlson's symmetric forms.
//!
//! The argument is the *complementary* modulus κ (for a contact ellipse κ = b/a, the ratio of its
//! axes), m = 1 - κ²: a slender ellipse would lose its digits in m. Formulas: NIST Digital Library
//! of Mathematical Functions, section 19.25; the symmetric forms come from the crate `ellip`.

use std::f64::consts::FRAC_PI_2;

use crate::analytic::error::{self, DomainError};

/// Smallest complementary modulus taken.
pub const SMALLEST_MODULUS: f64 = 1e-12;

/// Carlson's R_F(x, y, z); infinite where it diverges.
pub(crate) fn rf(x: f64, y: f64, z: f64) -> f64 {
    ellip::elliprf(x, y, z).unwrap_or(f64::INFINITY)
}

/// Carlson's R_D(x, y, z), z the argument that is not symmetric; infinite where it diverges.
pub(crate) fn rd(x: f64, y: f64, z: f64) -> f64 {
    ellip::elliprd(x, y, z).unwrap_or(f64::INFINITY)
}

fn modulus(kappa: f64) -> Result<f64, DomainError> {
    let allowed = (SMALLEST_MODULUS..=1.0).contains(&kappa);
    error::require(
        "complementary modulus",
        kappa,
        allowed,
        "at least 1e-12 and at most 1",
    )
}

fn amplitude(phi: f64) -> Result<f64, DomainError> {
    let allowed = (0.0..=FRAC_PI_2).contains(&phi);
    error::require("amplitude", phi, allowed, "at least 0 and at most π/2")
}

/// Complete integral of the first kind K(m), m = 1 - κ².
///
/// ```text
/// K = ∫₀^{π/2} dθ / √(1 - m sin²θ) = R_F(0, κ², 1)
/// ```
///
/// # Errors
/// [`DomainError::OutOfRange`] for κ outside [1e-12, 1].
pub fn complete_first(kappa: f64) -> Result<f64, DomainError> {
    let kappa = modulus(kappa)?;
    Ok(rf(0.0, kappa * kappa, 1.0))
}

/// Complete integral of the second kind E(m), m = 1 - κ².
///
/// ```text
/// E = ∫₀^{π/2} √(1 - m sin²θ) dθ = κ² [R_D(0, κ², 1) + R_D(0, 1, κ²)] / 3
/// ```
///
/// # Errors
/// [`DomainError::OutOfRange`] for κ outside [1e-12, 1].
pub fn complete_second(kappa: f64) -> Result<f64, DomainError> {
    let square = modulus(kappa)?.powi(2);
    Ok(square * (rd(0.0, square, 1.0) + rd(0.0, 1.0, square)) / 3.0)
}

/// Incomplete integral of the first kind F(φ, m), m = 1 - κ², φ in [0, π/2].
///
/// ```text
/// F = ∫₀^φ dθ / √(1 - m sin²θ) = sinφ R_F(cos²φ, 1 - m sin²φ, 1)
/// ```
///
/// # Errors
/// [`DomainError::OutOfRange`] for φ outside [0, π/2] or κ outside [1e-12, 1].
pub fn incomplete_first(phi: f64, kappa: f64) -> Result<f64, DomainError> {
    let (sin, cos) = amplitude(phi)?.sin_cos();
    let delta = cos * cos + (modulus(kappa)? * sin).powi(2);
    Ok(if phi == 0.0 {
        0.0
    } else {
        sin * rf(cos * cos, delta, 1.0)
    })
}

/// Incomplete integral of the second kind E(φ, m), m = 1 - κ², φ in [0, π/2].
///
/// ```text
/// E = ∫₀^φ √(1 - m sin²θ) dθ = F(φ, m) - (m/3) sin³φ R_D(cos²φ, 1 - m sin²φ, 1)
/// ```
///
/// # Errors
/// [`DomainError::OutOfRange`] for φ outside [0, π/2] or κ outside [1e-12, 1].
pub fn incomplete_second(phi: f64, kappa: f64) -> Result<f64, DomainError> {
    let first = incomplete_first(phi, kappa)?;
    let (sin, cos) = phi.sin_cos();
    let m = (1.0 - kappa) * (1.0 + kappa);
    let delta = cos * cos + (kappa * sin).powi(2);
    let share = if phi == 0.0 {
        0.0
    } else {
        sin.powi(3) * rd(cos * cos, delta, 1.0)
    };
    Ok(first - m / 3.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_gives_arcs() {
        assert!((complete_first(1.0).unwrap() - FRAC_PI_2).abs() < 1e-15);
        assert!((complete_second(1.0).unwrap() - FRAC_PI_2).abs() < 1e-15);
        assert!((incomplete_first(0.7, 1.0).unwrap() - 0.7).abs() < 1e-15);
        assert!((incomplete_second(0.7, 1.0).unwrap() - 0.7).abs() < 1e-15);
    }

    #[test]
    fn tabulated_values() {
        // Abramowitz and Stegun, tables 17.1 and 17.5 (m = 0.5; m = 0.25 is α = 30 degrees).
        let half = 0.5f64.sqrt();
        assert!((complete_first(half).unwrap() - 1.854_074_677_301_371_9).abs() < 1e-14);
        assert!((complete_second(half).unwrap() - 1.350_643_881_047_675_5).abs() < 1e-14);
        let phi = 30f64.to_radians();
        let kappa = 0.75f64.sqrt();
        assert!((incomplete_first(phi, kappa).unwrap() - 0.529_428_63).abs() < 1e-8);
        assert!((incomplete_second(phi, kappa).unwrap() - 0.517_881_93).abs() < 1e-8);
    }

    #[test]
    fn a_slender_ellipse_keeps_its_digits() {
        // K → ln(4/κ), E → 1 as κ → 0.
        let kappa = 1e-9;
        assert!((complete_first(kappa).unwrap() - (4.0 / kappa).ln()).abs() < 1e-13);
        assert!((complete_second(kappa).unwrap() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn legendres_relation_holds() {
        for kappa in [0.05, 0.3, 0.6, 0.9] {
            let other = (1.0f64 - kappa * kappa).sqrt();
            let (k, e) = (
                complete_first(kappa).unwrap(),
                complete_second(kappa).unwrap(),
            );
            let (k1, e1) = (
                complete_first(other).unwrap(),
                complete_second(other).unwrap(),
            );
            assert!((e * k1 + e1 * k - k * k1 - FRAC_PI_2).abs() < 1e-13);
        }
    }

    #[test]
    fn bad_arguments_are_refused() {
        assert!(complete_first(0.0).is_err());
        assert!(complete_second(1.1).is_err());
        assert!(incomplete_first(-0.1, 0.5).is_err());
        assert!(incomplete_second(2.0, 0.5).is_err());
        assert!(incomplete_second(f64::NAN, 0.5).is_err());
    }
}
