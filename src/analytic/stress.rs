//! A stress tensor and its invariants.

/// Stress components, tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stress {
    /// Normal stress along x, tension positive.
    pub xx: f64,
    /// Normal stress along y.
    pub yy: f64,
    /// Normal stress along z.
    pub zz: f64,
    /// Shear stress.
    pub xy: f64,
    /// Shear stress.
    pub yz: f64,
    /// Shear stress.
    pub zx: f64,
}

impl Stress {
    /// Normal stresses only.
    pub fn normal(xx: f64, yy: f64, zz: f64) -> Self {
        Self {
            xx,
            yy,
            zz,
            ..Self::default()
        }
    }

    /// Mises stress √(3 J₂), never negative.
    pub fn mises(&self) -> f64 {
        let normal = [self.xx - self.yy, self.yy - self.zz, self.zz - self.xx];
        let shear = [self.xy, self.yz, self.zx];
        // Squares of the components themselves could leave the floating-point range.
        let scale = normal
            .iter()
            .chain(&shear)
            .fold(0.0, |m: f64, c| m.max(c.abs()));
        if scale == 0.0 {
            return 0.0;
        }
        let square = |v: [f64; 3]| v.iter().map(|c| (c / scale).powi(2)).sum::<f64>();
        scale * (0.5 * square(normal) + 3.0 * square(shear)).sqrt()
    }

    /// Largest shear stress in the x-z plane, √(((σ_x - σ_z)/2)² + τ_zx²).
    pub fn shear_in_zx(&self) -> f64 {
        (0.5 * (self.xx - self.zz)).hypot(self.zx)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mises_of_simple_states() {
        assert_eq!(Stress::normal(-3.0, -3.0, -3.0).mises(), 0.0);
        assert_eq!(Stress::normal(0.0, 2.0, 0.0).mises(), 2.0);
        let shear = Stress {
            zx: 1.0,
            ..Stress::default()
        };
        assert!((shear.mises() - 3f64.sqrt()).abs() < 1e-15);
        assert_eq!(shear.shear_in_zx(), 1.0);
    }
}
