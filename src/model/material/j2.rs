//! J2 plasticity with linear isotropic hardening, integrated by radial return.
//!
//! Backward Euler is exact here in closed form: with q the trial Mises stress and α the
//! equivalent plastic strain, Δγ = (q − σ_y − Hα) / (3G + H)
//! (de Souza Neto, Perić, Owen, *Computational Methods for Plasticity*, 2008, box 7.4).

use super::{Moduli, Steel, mises};
use serde::{Deserialize, Serialize};

/// Plastic history of one integration point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PlasticPoint {
    /// Plastic strain xx yy zz xy yz zx, engineering shears.
    pub strain: [f64; 6],
    /// Equivalent plastic strain (PEEQ).
    pub peeq: f64,
}

/// The answer of one integration point to a total strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Update {
    /// Stress xx yy zz xy yz zx.
    pub stress: [f64; 6],
    /// The history at the end of the update.
    pub point: PlasticPoint,
    /// Present where the point flows in this update.
    pub flow: Option<Flow>,
}

/// What the consistent tangent needs where a point flows:
/// C = K 1⊗1 + 2G β I_dev − `softening` N⊗N, N the unit direction of the deviator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// β, what flow leaves of the shear stiffness of the deviator; below 1.
    pub beta: f64,
    /// Stiffness that is lost along the direction of flow, a stress.
    pub softening: f64,
    /// Unit stress deviator.
    pub direction: [f64; 6],
}

/// Stress, new history and flow at total strain `strain`, from the history `old`.
pub fn update(steel: &Steel, elastic: &Moduli, strain: &[f64; 6], old: &PlasticPoint) -> Update {
    let trial_strain = std::array::from_fn(|i| strain[i] - old.strain[i]);
    let trial = elastic.stress(&trial_strain);
    let q = mises(&trial);
    let yield_now = steel.flow_stress(old.peeq);
    if q <= yield_now {
        return Update {
            stress: trial,
            point: *old,
            flow: None,
        };
    }
    let g3 = 3.0 * elastic.shear;
    let multiplier = (q - yield_now) / (g3 + steel.hardening_modulus);
    let beta = 1.0 - g3 * multiplier / q;
    let pressure = (trial[0] + trial[1] + trial[2]) / 3.0;
    let deviator: [f64; 6] =
        std::array::from_fn(|i| if i < 3 { trial[i] - pressure } else { trial[i] });
    let stress = std::array::from_fn(|i| beta * deviator[i] + if i < 3 { pressure } else { 0.0 });
    let mut point = *old;
    point.peeq += multiplier;
    for i in 0..6 {
        let shear = if i < 3 { 1.0 } else { 2.0 };
        point.strain[i] += shear * 1.5 * multiplier / q * deviator[i];
    }
    // |s| = √(2/3) q makes the direction a unit tensor.
    let norm = (2.0f64 / 3.0).sqrt() * q;
    let flow = Flow {
        beta,
        softening: 6.0
            * elastic.shear
            * elastic.shear
            * (1.0 / (g3 + steel.hardening_modulus) - multiplier / q),
        direction: deviator.map(|s| s / norm),
    };
    Update {
        stress,
        point,
        flow: Some(flow),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steel() -> Steel {
        Steel {
            youngs_modulus: 29500.0,
            poissons_ratio: 0.3,
            yield_stress: 100.0,
            hardening_modulus: 249.471,
        }
    }

    #[test]
    fn the_tangent_is_the_derivative_of_the_stress() {
        let (steel, elastic) = (steel(), steel().moduli());
        let strain = [0.004, -0.001, 0.0005, 0.003, -0.002, 0.001];
        let old = PlasticPoint::default();
        let base = update(&steel, &elastic, &strain, &old);
        let flow = base.flow.expect("it yields");
        for j in 0..6 {
            let h = 1e-7;
            let (mut up, mut down) = (strain, strain);
            up[j] += h;
            down[j] -= h;
            let (up, down) = (
                update(&steel, &elastic, &up, &old),
                update(&steel, &elastic, &down, &old),
            );
            for i in 0..6 {
                let numeric = (up.stress[i] - down.stress[i]) / (2.0 * h);
                let dev = if i < 3 && j < 3 {
                    2.0 * (f64::from(u8::from(i == j)) - 1.0 / 3.0)
                } else {
                    f64::from(u8::from(i == j))
                };
                let volumetric = if i < 3 && j < 3 { elastic.bulk } else { 0.0 };
                let exact = volumetric + elastic.shear * flow.beta * dev
                    - flow.softening * flow.direction[i] * flow.direction[j];
                assert!((numeric - exact).abs() < 1e-4 * elastic.bulk, "{i} {j}");
            }
        }
    }

    #[test]
    fn flow_ends_on_the_hardened_surface() {
        let (steel, elastic) = (steel(), steel().moduli());
        let old = PlasticPoint {
            strain: [0.0; 6],
            peeq: 0.01,
        };
        let new = update(&steel, &elastic, &[0.02, -0.01, 0.0, 0.01, 0.0, 0.02], &old);
        let surface = 100.0 + 249.471 * new.point.peeq;
        assert!((mises(&new.stress) - surface).abs() < 1e-10);
    }
}
