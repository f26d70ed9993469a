//! The energy of the error, from a smoother stress.

use crate::answer::results::hex::GaussRule;
use crate::answer::results::recovery::Recovered;
use crate::model::material::Steel;
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;
use rayon::prelude::*;

/// Energy of the error, ∫ (σ* − σ) : C⁻¹ : (σ* − σ) dV over the modelled part, where σ* is
/// interpolated from the nodal averages of the stress σ at the integration points (Zienkiewicz and
/// Zhu 1987). Twice a strain energy, as ∫ σ : ε is.
pub fn of_error(scene: &Scene, state: &State, recovered: &Recovered) -> f64 {
    let rule = GaussRule::new();
    integral(scene, state, recovered, |point, stress, nodal| {
        let mut difference = stress.map(|s| -s);
        for (weight, nodal) in rule.shape[point].iter().zip(nodal) {
            for (d, s) in difference.iter_mut().zip(nodal) {
                *d += weight * s;
            }
        }
        difference
    })
}

/// The same of the stress itself, ∫ σ : C⁻¹ : σ dV.
pub fn of_solution(scene: &Scene, state: &State, recovered: &Recovered) -> f64 {
    integral(scene, state, recovered, |_, stress, _| *stress)
}

/// ∫ τ : C⁻¹ : τ dV of the stress τ that an integration point has, by its number, its stress and those of the nodes.
fn integral(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    of: impl Fn(usize, &[f64; 6], &[[f64; 6]; 8]) -> [f64; 6] + Sync,
) -> f64 {
    let of_body = |(body, steel): (&Body, &Steel)| -> f64 {
        let (e, nu) = (steel.youngs_modulus, steel.poissons_ratio);
        let of_element = |element: usize| -> f64 {
            let corners = recovered.points.cells[element];
            let nodal = corners.map(|p| recovered.nodal_stress[p as usize]);
            let points = state.stress[element].iter().enumerate();
            let densities = points.map(|(point, stress)| {
                let volume = recovered.volumes[element][point];
                density(&of(point, stress, &nodal), e, nu) * volume
            });
            densities.sum()
        };
        // Summed in order, so that the number of threads changes nothing.
        let elements: Vec<f64> = (body.elements.clone().into_par_iter())
            .map(of_element)
            .collect();
        elements.iter().sum()
    };
    (scene.mesh.bodies.iter().zip(&scene.materials))
        .map(of_body)
        .sum()
}

/// σ : C⁻¹ : σ of an isotropic body.
fn density(stress: &[f64; 6], youngs_modulus: f64, poissons_ratio: f64) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = *stress;
    let square = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + yz * yz + zx * zx);
    let trace = xx + yy + zz;
    ((1.0 + poissons_ratio) * square - poissons_ratio * trace * trace) / youngs_modulus
}
