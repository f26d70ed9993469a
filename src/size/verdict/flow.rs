//! Plastic strain of a body, beside loaded edges and away from them.

use crate::job::Outcome;
use crate::results::edges::LoadedEdges;
use crate::results::hex::centre;

/// Largest equivalent plastic strain of a body.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Flow {
    /// Beside loaded edges of contact surfaces, such as square ends of rollers.
    pub at_edges: f64,
    pub away: f64,
}

/// One for each body, in the order of the mesh.
pub fn flows(outcome: &Outcome) -> Vec<Flow> {
    let (scene, state) = (&outcome.scene, outcome.state());
    let edges = LoadedEdges::find(scene, state);
    let of_body = |elements: std::ops::Range<usize>| {
        let mut flow = Flow::default();
        for element in elements {
            let strain = state.peeq_of(element).iter().copied().fold(0.0, f64::max);
            if strain == 0.0 {
                continue;
            }
            let at = centre(&scene.mesh.corners(element));
            let side = match edges.are_near(&at) {
                true => &mut flow.at_edges,
                false => &mut flow.away,
            };
            *side = side.max(strain);
        }
        flow
    };
    let bodies = scene.mesh.bodies.iter();
    bodies.map(|body| of_body(body.elements.clone())).collect()
}
