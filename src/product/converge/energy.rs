//! Potential energy of an elastic state.

use crate::answer::results::quad::integrate;
use crate::ground::geometry::norm;
use crate::model::material::Moduli;
use crate::model::mesh::hexahedron::gauss_volumes;
use crate::model::mesh::quadrilateral::area_vector;
use crate::model::scene::{Scene, TractionValue};
use crate::model::state::State;

/// Π = ½ ∫ σ:ε dV − ∫ t·u dA of the modelled part, for elastic bodies under tractions.
pub fn potential(scene: &Scene, state: &State) -> f64 {
    strain_energy(scene, state) - work(scene, state)
}

/// ½ ∫ σ:C⁻¹:σ dV: σ:C⁻¹:σ = (tr σ)² / 9K + s:s / 2G.
pub fn strain_energy(scene: &Scene, state: &State) -> f64 {
    let mesh = &scene.mesh;
    let mut sum = 0.0;
    for (body, steel) in mesh.bodies.iter().zip(&scene.materials) {
        let Moduli { shear, bulk } = steel.moduli();
        for e in body.elements.clone() {
            let volumes = gauss_volumes(&mesh.corners(e));
            for (s, v) in state.stress[e].iter().zip(volumes) {
                let trace = s[0] + s[1] + s[2];
                let normal = s[..3]
                    .iter()
                    .map(|n| (n - trace / 3.0).powi(2))
                    .sum::<f64>();
                let shears = s[3..].iter().map(|t| t * t).sum::<f64>();
                let density =
                    trace * trace / (9.0 * bulk) + (normal + 2.0 * shears) / (2.0 * shear);
                sum += 0.5 * v * density;
            }
        }
    }
    sum
}

/// Tractions at their factors, times the displacements.
fn work(scene: &Scene, state: &State) -> f64 {
    let mut sum = 0.0;
    for traction in &scene.tractions {
        let Some(surface) = scene.mesh.surface(&traction.surface) else {
            continue;
        };
        let scale = scene.factor(&traction.name, state.step, state.time);
        for face in &surface.faces {
            let corners = face.corners(&scene.mesh);
            let whole = area_vector(&corners);
            let size = norm(whole);
            let force = match traction.value {
                TractionValue::Pressure(p) => whole.map(|c| -p * c / size),
                TractionValue::Vector(t) => t,
            };
            let moved = face.nodes.map(|n| state.displacement[n as usize]);
            integrate(&corners, |shape, area| {
                for (n, u) in shape.iter().zip(moved) {
                    sum += scale * area * n * (0..3).map(|i| force[i] * u[i]).sum::<f64>();
                }
            });
        }
    }
    sum
}
