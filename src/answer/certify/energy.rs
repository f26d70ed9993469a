//! The energy of the error, from a smoother stress.

use super::linings;
use super::strain_energy::{density, elastic_strain, work};
use super::strip_below::StripBelow;
use super::thin_walls::smooth_stress;
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::hex::{GaussRule, centre, interpolate};
use crate::answer::results::outer_faces::OuterFaces;
use crate::answer::results::recovery::Recovered;
use crate::answer::results::strain::strain;
use crate::model::material::{Steel, mises};
use crate::model::mesh::Body;
use crate::model::scene::Scene;
use crate::model::state::State;
use rayon::prelude::*;

/// What a load does not do on the displacement that the mesh misses, over the modelled part.
pub struct Missing {
    /// That of the load.
    pub work: f64,
    /// The energy of the error alone, body by body.
    pub errors: Vec<f64>,
    /// Of that, what lies beside singular edges, of all bodies.
    pub beside_edges: f64,
}

/// What a load does not do on the displacement that the mesh misses, over the modelled part:
/// ∫ (σ* − σ) : C⁻¹ : (σ* − σ) dV + 2 ∫ (σ* − σ) : ε̃ dV.
///
/// σ* is interpolated from the nodal averages of the stress σ at the integration points and stands for the true
/// stress (Zienkiewicz and Zhu 1987), but for the faces of thin walls (`thin_walls.rs`) and of linings (`linings.rs`); the first term is the energy of the
/// error, which is returned of the averages everywhere. ε̃ is the strain that an element
/// assumes beyond that of its displacements: B-bar's mean dilatation, the modes of the enhanced hexahedron. They make
/// it softer; of the plain hexahedron there are none. Where steel has flowed only its volume says how much is assumed,
/// as flow keeps the volume. Where a body is warmed nothing does.
pub fn missing_work(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    (outer, edges): (&OuterFaces, &SingularEdges),
) -> Missing {
    let rule = GaussRule::new();
    let points = scene.mesh.points.par_iter();
    let is_near: Vec<bool> = points.map(|at| edges.are_near(at)).collect();
    let warmed = !scene.temperatures.is_empty();
    let smooth = smooth_stress(scene, state, recovered, outer);
    let of_bodies = integrals(scene, recovered, |steel, element| {
        let at_nodes = |of: &[[f64; 6]]| recovered.points.cells[element].map(|p| of[p as usize]);
        let (smooth, averages) = (at_nodes(&smooth), at_nodes(&recovered.nodal_stress));
        let corners = scene.mesh.corners(element);
        let nodes = &scene.mesh.hexes[element];
        let moved = nodes.map(|n| state.displacement[n as usize]);
        let peeq = state.peeq_of(element);
        let beside = f64::from(u8::from(nodes.iter().any(|node| is_near[*node as usize])));
        std::array::from_fn(|point| {
            let stress = &state.stress[element][point];
            let beyond = |nodal: &[[f64; 6]; 8]| -> [f64; 6] {
                let smooth = interpolate(&rule.shape[point], nodal);
                std::array::from_fn(|k| smooth[k] - stress[k])
            };
            let missing = beyond(&smooth);
            let error = density(&beyond(&averages), steel);
            if warmed {
                return [error, error, beside * error];
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
            [
                density(&missing, steel) + 2.0 * work(&missing, &assumed),
                error,
                beside * error,
            ]
        })
    });
    Missing {
        work: of_bodies.iter().map(|[work, ..]| work).sum::<f64>()
            + linings::work_at_sides(scene, state, outer),
        errors: of_bodies.iter().map(|[_, error, _]| *error).collect(),
        beside_edges: of_bodies.iter().map(|[.., error]| error).sum(),
    }
}

/// The same of the stress itself, ∫ σ : C⁻¹ : σ dV. Twice a strain energy, as ∫ σ : ε is.
pub fn of_solution(scene: &Scene, state: &State, recovered: &Recovered) -> f64 {
    of_bodies(scene, state, recovered).iter().sum()
}

/// That of each body.
pub(super) fn of_bodies(scene: &Scene, state: &State, recovered: &Recovered) -> Vec<f64> {
    let of_bodies = integrals(scene, recovered, |steel, element| {
        state.stress[element].map(|stress| [density(&stress, steel)])
    });
    of_bodies.into_iter().map(|[energy]| energy).collect()
}

/// Mises stress over the flow stress from which on steel flows.
const FLOWS: f64 = 1.0 - 1e-6;

/// What steel does where it flows and no strip is above.
#[derive(Debug, Clone, Default)]
pub(super) struct FreeFlow {
    /// Share of the work of all flow.
    pub share: f64,
    /// Work of what the smoother Mises stress is beyond the flow stress on the strain that steel hardens by meanwhile, body by body:
    /// ∫ (σ* − σ_y)²/H dV over the modelled part, where it flows or would.
    pub work_beyond: Vec<f64>,
}

/// Of a state.
pub(super) fn free_flow(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    strips: &[StripBelow<'_>],
) -> FreeFlow {
    let rule = GaussRule::new();
    let of_bodies = integrals(scene, recovered, |steel, element| {
        let corners = scene.mesh.corners(element);
        let at = centre(&corners);
        let is_away = !strips.iter().any(|strip| strip.is_above(&at));
        let away = f64::from(u8::from(is_away));
        let smooth = recovered.points.cells[element].map(|p| recovered.nodal_stress[p as usize]);
        let peeq = state.peeq_of(element);
        std::array::from_fn(|point| {
            let flow_stress = steel.flow_stress(peeq[point]);
            // Of what cannot flow the yield stress has no bound.
            let work = match peeq[point] > 0.0 {
                true => 0.5 * peeq[point] * (steel.yield_stress + flow_stress),
                false => 0.0,
            };
            let beyond = mises(&interpolate(&rule.shape[point], &smooth)) - flow_stress;
            let flows = mises(&state.stress[element][point]) > FLOWS * flow_stress;
            let hardens = steel.hardening_modulus > 0.0 && (flows || beyond > 0.0);
            let work_beyond = match hardens {
                true => away * beyond.powi(2) / steel.hardening_modulus,
                false => 0.0,
            };
            [work, away * work, work_beyond]
        })
    });
    let sum = |part: usize| of_bodies.iter().map(|works| works[part]).sum::<f64>();
    let all = sum(0);
    FreeFlow {
        share: if all > 0.0 { sum(1) / all } else { 0.0 },
        work_beyond: of_bodies.iter().map(|[.., work]| *work).collect(),
    }
}

/// The integrals of densities that the points of an element have, by its steel and its number, over each body.
fn integrals<const N: usize>(
    scene: &Scene,
    recovered: &Recovered,
    of: impl Fn(&Steel, usize) -> [[f64; N]; 8] + Sync,
) -> Vec<[f64; N]> {
    let add = |mut sum: [f64; N], more: [f64; N]| {
        sum.iter_mut()
            .zip(more)
            .for_each(|(sum, more)| *sum += more);
        sum
    };
    let of_body = |(body, steel): (&Body, &Steel)| {
        let of_element = |element: usize| {
            let densities = of(steel, element).into_iter();
            let weighed =
                (densities.zip(&recovered.volumes[element])).map(|(d, v)| d.map(|d| d * v));
            weighed.fold([0.0; N], add)
        };
        // Summed in order, so that the number of threads changes nothing.
        let elements: Vec<_> = (body.elements.clone().into_par_iter())
            .map(of_element)
            .collect();
        elements.into_iter().fold([0.0; N], add)
    };
    (scene.mesh.bodies.iter().zip(&scene.materials))
        .map(of_body)
        .collect()
}
