//! Steel: isotropic elasticity and J2 plasticity with linear isotropic hardening.

/// Isotropic steel with a straight hardening line.
///
/// Stresses in the stress unit of the scene, tension positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steel {
    /// Young's modulus E.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, in (-1, 0.5).
    pub poissons_ratio: f64,
    /// Yield stress in uniaxial tension; infinite for a purely elastic body.
    pub yield_stress: f64,
    /// Hardening modulus H = dσ/dε_p; zero for perfect plasticity.
    pub hardening_modulus: f64,
}
