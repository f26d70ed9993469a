//! The energy of the error, from a smoother stress.

use crate::answer::results::hex::GaussRule;
use crate::answer::results::recovery::Recovered;
use crate::answer::results::strain::strain;
use crate::model::material::Steel;
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;
use rayon::prelude::*;

/// What a load does not do on the displacement that the mesh misses, over the modelled part:
/// ∫ (σ* − σ) : C⁻¹ : (σ* − σ) dV + 2 ∫ (σ* − σ) : ε̃ dV.
///
/// σ* is interpolated from the nodal averages of the stress σ at the integration points and stands for the true
/// stress (Zienkiewicz and Zhu 1987); the first term is the energy of the error. ε̃ is the strain that an element
/// assumes beyond that of its displacements: B-bar's mean dilatation, the modes of the enhanced hexahedron. They make
/// it softer; of the plain hexahedron there are none. Where steel has flowed only its volume says how much is assumed,
/// as flow keeps the volume. Where a body is warmed nothing does.
pub fn missing_work(scene: &Scene, state: &State, recovered: &Recovered) -> f64 {
    let rule = GaussRule::new();
    let warmed = !scene.temperatures.is_empty();
    integral(scene, recovered, |steel, element, nodal| {
        let corners = scene.mesh.corners(element);
        let moved = scene.mesh.hexes[element].map(|n| state.displacement[n as usize]);
        let peeq = state.peeq_of(element);
        std::array::from_fn(|point| {
            let stress = &state.stress[element][point];
            let mut missing = stress.map(|s| -s);
            for (weight, nodal) in rule.shape[point].iter().zip(nodal) {
                for (m, s) in missing.iter_mut().zip(nodal) {
                    *m += weight * s;
                }
            }
            let error = density(&missing, steel);
            if warmed {
                return error;
            }
            let own = strain(&rule.gradients[point], &corners, &moved);
            let mut assumed = elastic_strain(stress, steel);
            for (a, s) in assumed.iter_mut().zip(own) {
                *a -= s;
            }
            if peeq[point] > 0.0 {
                let third = (assumed[0] + assumed[1] + assumed[2]) / 3.0;
                assumed = [third, third, third, 0.0, 0.0, 0.0];
            }
            error + 2.0 * work(&missing, &assumed)
        })
    })
}

/// The same of the stress itself, ∫ σ : C⁻¹ : σ dV. Twice a strain energy, as ∫ σ : ε is.
pub fn of_solution(scene: &Scene, state: &State, recovered: &Recovered) -> f64 {
    integral(scene, recovered, |steel, element, _| {
        state.stress[element].map(|stress| density(&stress, steel))
    })
}

/// The integral of densities that the points of an element have, by its steel, its number and the stresses of its
/// nodes.
fn integral(
    scene: &Scene,
    recovered: &Recovered,
    of: impl Fn(&Steel, usize, &[[f64; 6]; 8]) -> [f64; 8] + Sync,
) -> f64 {
    let of_body = |(body, steel): (&Body, &Steel)| -> f64 {
        let of_element = |element: usize| -> f64 {
            let corners = recovered.points.cells[element];
            let nodal = corners.map(|p| recovered.nodal_stress[p as usize]);
            let densities = of(steel, element, &nodal);
            let volumes = &recovered.volumes[element];
            densities.iter().zip(volumes).map(|(d, v)| d * v).sum()
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

/// τ : C⁻¹ : τ of a stress.
fn density(stress: &[f64; 6], steel: &Steel) -> f64 {
    work(stress, &elastic_strain(stress, steel))
}

/// C⁻¹ : σ, with engineering shears.
fn elastic_strain(stress: &[f64; 6], steel: &Steel) -> [f64; 6] {
    let (e, nu) = (steel.youngs_modulus, steel.poissons_ratio);
    let trace = stress[0] + stress[1] + stress[2];
    std::array::from_fn(|i| match i < 3 {
        true => ((1.0 + nu) * stress[i] - nu * trace) / e,
        false => 2.0 * (1.0 + nu) * stress[i] / e,
    })
}

/// σ : ε of a stress and a strain with engineering shears.
fn work(stress: &[f64; 6], strain: &[f64; 6]) -> f64 {
    stress.iter().zip(strain).map(|(s, e)| s * e).sum()
}
