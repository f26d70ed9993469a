//! A quarter of a ring, and the pressure on its facets.

use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::proof::verify::VerifyError;
use crate::proof::verify::kit;
use std::f64::consts::FRAC_PI_2;

/// Outer radius, in.
pub const RADIUS: f64 = 1.5;
/// Load per length, kip/in.
pub const LOAD: f64 = 8.125;
/// Half angle of the loaded arc.
pub const SPREAD: f64 = 0.02;
/// Thickness of the one layer, in.
const LAYER: f64 = 0.1;

/// The name of the loaded strip `k`.
pub fn strip(k: usize) -> String {
    format!("strip {k}")
}

/// A quarter, loaded around the x axis on `strip 0`, `strip 1`, ..., and the edges of the strips.
pub fn mesh(inner: f64, layers: usize) -> Result<(Mesh, Vec<f64>), VerifyError> {
    let size = (RADIUS - inner) / layers as f64;
    let angles = angles(0.25 * SPREAD, 1.5 * size / RADIUS);
    let mut mesh = Block::new(
        "ring",
        radii(inner, layers),
        angles.clone(),
        uniform(0.0, LAYER, 1),
    )
    .mapped(kit::quarter)
    .build()?;
    let loaded = 1 + angles.iter().filter(|a| **a < SPREAD).count();
    let edges = angles[..loaded].to_vec();
    for (k, arc) in edges.windows(2).enumerate() {
        mesh.mark(&strip(k), "ring", |[x, y, _]| {
            let (radius, angle) = (x.hypot(y), y.atan2(x));
            let within = angle > arc[0] - 1e-9 && angle < arc[1] + 1e-9;
            within && radius > RADIUS * (1.0 - 1e-9)
        });
    }
    Ok((mesh, edges))
}

/// Radii of the nodes: equal layers, the outermost halved three times for the pressed arc.
fn radii(inner: f64, layers: usize) -> Vec<f64> {
    let mut list = uniform(inner, RADIUS, layers);
    let size = (RADIUS - inner) / layers as f64;
    list.pop();
    list.extend([2.0, 4.0, 8.0].map(|part| RADIUS - size / part));
    list.push(RADIUS);
    list
}

/// Angles of the nodes: steps of `fine` under the load, growing to `coarse`.
fn angles(fine: f64, coarse: f64) -> Vec<f64> {
    const GROWTH: f64 = 1.25;
    let (mut list, mut end, mut step) = (vec![0.0], 0.0, fine);
    while end < FRAC_PI_2 {
        if end > 1.2 * SPREAD {
            step = f64::min(GROWTH * step, f64::max(coarse, fine));
        }
        end += step;
        list.push(end);
    }
    list.iter().map(|a| a * FRAC_PI_2 / end).collect()
}

/// Pressure of the facet between two angles that carries the load of its arc.
pub fn mean_pressure(from: f64, to: f64) -> f64 {
    // ∫ √(1 − s²) ds = ½ (s √(1 − s²) + arcsin s); over [0, 1] it is π/4.
    let carried = |angle: f64| {
        let s = (angle / SPREAD).min(1.0);
        0.5 * (s * (1.0 - s * s).max(0.0).sqrt() + s.asin())
    };
    let peak = LOAD / (RADIUS * SPREAD * FRAC_PI_2);
    let chord = 2.0 * (0.5 * (to - from)).sin();
    peak * SPREAD * (carried(to) - carried(from)) / chord
}
