//! What is read from the mesh and the state of a scene of the ladder.

use crate::model::mesh::hexahedron::gauss_volumes;
use crate::model::mesh::{Mesh, Surface};
use crate::model::state::State;
use crate::proof::verify::VerifyError;

/// The surface called `name`.
pub fn surface<'a>(mesh: &'a Mesh, name: &str) -> Result<&'a Surface, VerifyError> {
    mesh.surface(name).ok_or(VerifyError::Missing("surface"))
}

/// Mean displacement of the nodes of a surface.
pub fn mean_displacement(mesh: &Mesh, state: &State, name: &str) -> Result<[f64; 3], VerifyError> {
    let nodes = surface(mesh, name)?.nodes();
    let mut sum = [0.0; 3];
    for node in &nodes {
        for (s, u) in sum.iter_mut().zip(state.displacement[*node as usize]) {
            *s += u / nodes.len() as f64;
        }
    }
    Ok(sum)
}

/// Displacement of the node next to `at`.
pub fn displacement_at(mesh: &Mesh, state: &State, at: [f64; 3]) -> Result<[f64; 3], VerifyError> {
    let distance = |p: &[f64; 3]| (0..3).map(|i| (p[i] - at[i]).powi(2)).sum::<f64>();
    let nodes = 0..mesh.points.len();
    let node =
        nodes.min_by(|a, b| distance(&mesh.points[*a]).total_cmp(&distance(&mesh.points[*b])));
    let node = node.ok_or(VerifyError::Missing("node"))?;
    Ok(state.displacement[node])
}

/// ∫ σ dV over the modelled part, component by component.
///
/// By virtual work with a displacement u = x along an axis, the force times the height of a body
/// that is pressed between planes across that axis: exact for what the solver balanced.
pub fn stress_integral(mesh: &Mesh, state: &State) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for (e, points) in state.stress.iter().enumerate() {
        for (stress, volume) in points.iter().zip(gauss_volumes(&mesh.corners(e))) {
            for (s, t) in sum.iter_mut().zip(stress) {
                *s += t * volume;
            }
        }
    }
    sum
}
