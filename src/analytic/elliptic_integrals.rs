//! Carlson's symmetric elliptic integrals, from the crate `ellip`.
//!
//! Legendre's complete integrals of the complementary modulus κ (for a contact ellipse κ = b/a, the ratio of its axes) are
//! K = R_F(0, κ², 1) and E = κ² [R_D(0, κ², 1) + R_D(0, 1, κ²)] / 3 (NIST Digital Library of Mathematical Functions,
//! section 19.25). In κ a slender ellipse keeps its digits, which it would lose in m = 1 - κ².

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

#[cfg(test)]
mod tests {
    use super::*;

    fn complete(kappa: f64) -> [f64; 2] {
        let square = kappa * kappa;
        let second = square * (rd(0.0, square, 1.0) + rd(0.0, 1.0, square)) / 3.0;
        [rf(0.0, square, 1.0), second]
    }

    /// Abramowitz and Stegun, table 17.1, m = 0.5.
    #[test]
    fn tabulated_values() {
        let [first, second] = complete(0.5f64.sqrt());
        assert!((first - 1.854_074_677_301_371_9).abs() < 1e-14);
        assert!((second - 1.350_643_881_047_675_5).abs() < 1e-14);
    }

    /// K → ln(4/κ), E → 1 as κ → 0.
    #[test]
    fn a_slender_ellipse_keeps_its_digits() {
        let [first, second] = complete(1e-9);
        assert!((first - 4e9f64.ln()).abs() < 1e-13);
        assert!((second - 1.0).abs() < 1e-14);
    }
}
