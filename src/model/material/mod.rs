//! Steel: isotropic elasticity and J2 plasticity with linear isotropic hardening.

#[doc(hidden)]
pub mod j2;

use serde::Serialize;

/// Isotropic steel with a straight hardening line.
///
/// Stresses in the stress unit of the scene, tension positive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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

impl Steel {
    /// A steel that never yields.
    pub fn elastic(youngs_modulus: f64, poissons_ratio: f64) -> Self {
        Self {
            youngs_modulus,
            poissons_ratio,
            yield_stress: f64::INFINITY,
            hardening_modulus: 0.0,
        }
    }

    /// Can it yield at all?
    pub fn is_elastic(&self) -> bool {
        self.yield_stress.is_infinite()
    }

    /// Mises stress at which it flows, at the equivalent plastic strain `peeq`.
    pub fn flow_stress(&self, peeq: f64) -> f64 {
        self.yield_stress + self.hardening_modulus * peeq
    }

    /// Shear and bulk modulus.
    pub fn moduli(&self) -> Moduli {
        let (e, nu) = (self.youngs_modulus, self.poissons_ratio);
        Moduli {
            shear: e / (2.0 * (1.0 + nu)),
            bulk: e / (3.0 * (1.0 - 2.0 * nu)),
        }
    }
}

/// Isotropic moduli G and K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moduli {
    /// G, a stress.
    pub shear: f64,
    /// K, a stress.
    pub bulk: f64,
}

impl Moduli {
    /// Hooke's law: stress from strain (engineering shears).
    pub fn stress(&self, strain: &[f64; 6]) -> [f64; 6] {
        let volume = strain[0] + strain[1] + strain[2];
        let pressure = (self.bulk - 2.0 / 3.0 * self.shear) * volume;
        std::array::from_fn(|i| {
            if i < 3 {
                2.0 * self.shear * strain[i] + pressure
            } else {
                self.shear * strain[i]
            }
        })
    }
}

/// The matrix of a stress tensor xx yy zz xy yz zx: its rows are the tractions on planes across the axes.
pub fn matrix([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> [[f64; 3]; 3] {
    [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]
}

/// Mises stress of a stress tensor xx yy zz xy yz zx.
pub fn mises(s: &[f64; 6]) -> f64 {
    let d = [s[0] - s[1], s[1] - s[2], s[2] - s[0]];
    let normal = 0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    (normal + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])).sqrt()
}
