//! Contact pressure and plastic strain at the points of the bodies, to be shown in colour.

use crate::answer::results::hex::GaussRule;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::State;

/// The pressure at the points of the bodies, on the surface of each pair that carries it.
pub fn pressure(scene: &Scene, state: &State, recovered: &Recovered) -> Vec<f64> {
    let mut at_nodes = vec![0.0f64; scene.mesh.points.len()];
    for field in &state.contacts {
        for (node, pressure) in field.nodes.iter().zip(&field.pressure) {
            let value = &mut at_nodes[*node as usize];
            *value = value.max(*pressure);
        }
    }
    let nodes = recovered.points.node.iter();
    nodes.map(|n| at_nodes[*n as usize]).collect()
}

/// Extrapolated to the corners of each element and averaged, as stresses are; never negative.
pub fn plastic_strain(state: &State, recovered: &Recovered) -> Vec<f64> {
    let mut sums = vec![(0.0, 0u32); recovered.points.node.len()];
    if state.peeq.is_empty() {
        return vec![0.0; sums.len()];
    }
    let rule = GaussRule::new();
    for (cell, peeq) in recovered.points.cells.iter().zip(&state.peeq) {
        let corners = match peeq.iter().any(|p| *p > 0.0) {
            true => rule.extrapolate(&peeq.map(|p| [p, 0.0, 0.0, 0.0, 0.0, 0.0])),
            false => [[0.0; 6]; 8],
        };
        for (point, corner) in cell.iter().zip(corners) {
            let (sum, count) = &mut sums[*point as usize];
            *sum += corner[0].max(0.0);
            *count += 1;
        }
    }
    let mean = |(sum, count): (f64, u32)| sum / f64::from(count.max(1));
    sums.into_iter().map(mean).collect()
}
