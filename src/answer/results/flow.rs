//! Plastic strain of a body, beside singular edges and away from them.

use super::edges::SingularEdges;
use super::hex::centre;
use super::tensor::mises;
use crate::model::scene::Scene;
use crate::model::state::State;

/// Largest equivalent plastic strain of a body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyFlow {
    /// Beside singular edges, such as square ends of rollers.
    pub at_edges: f64,
    /// Away from such edges.
    pub away: f64,
    /// Largest Mises stress of the mean stress of an element that flows away from edges; zero where
    /// none does.
    pub mean_mises: f64,
}

/// One for each body, in the order of the mesh.
pub fn flows(scene: &Scene, state: &State, edges: &SingularEdges) -> Vec<BodyFlow> {
    let of_body = |elements: std::ops::Range<usize>| {
        let mut flow = BodyFlow::default();
        for element in elements {
            let points = state.peeq_of(element);
            let strain = points.iter().copied().fold(0.0, f64::max);
            if strain == 0.0 {
                continue;
            }
            let at = centre(&scene.mesh.corners(element));
            if edges.are_near(&at) {
                flow.at_edges = flow.at_edges.max(strain);
                continue;
            }
            flow.away = flow.away.max(strain);
            let stress = &state.stress[element];
            let sum = |part: usize| stress.iter().map(|s| s[part]).sum::<f64>();
            let mean = std::array::from_fn(|part| sum(part) / stress.len() as f64);
            flow.mean_mises = flow.mean_mises.max(mises(&mean));
        }
        flow
    };
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|body| of_body(body.elements.clone())).collect()
}
