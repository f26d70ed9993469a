//! Stress in polar components.

use crate::analytic::Stress;

/// Stress in polar components, tension positive; θ runs from the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolarStress {
    /// Along the radius, tension positive.
    pub radial: f64,
    /// Around the axis.
    pub hoop: f64,
    /// Along the axis.
    pub axial: f64,
    /// Shear between radius and hoop.
    pub shear: f64,
}

impl PolarStress {
    /// Mises stress.
    pub fn mises(&self) -> f64 {
        let normal = Stress::normal(self.radial, self.hoop, self.axial);
        Stress {
            xy: self.shear,
            ..normal
        }
        .mises()
    }
}
