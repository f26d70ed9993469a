//! Friction cones as polyhedra: the forces that a contact point can carry are sums of their edges.

use crate::solver::solve::params::CONE_EDGES;
use crate::solver::solve::rigid::touch::Touch;
use nalgebra::DVector;
use std::f64::consts::PI;

/// Edges of the cones of friction, a column each; `friction` says what becomes of a coefficient.
pub fn cones(points: &[Touch], friction: impl Fn(f64) -> f64) -> Vec<DVector<f64>> {
    let mut edges = Vec::new();
    for point in points {
        let Some([s, t]) = &point.tangents else {
            edges.push(point.normal.clone());
            continue;
        };
        let friction = friction(point.friction);
        edges.extend((0..CONE_EDGES).map(|k| {
            let angle = 2.0 * PI * k as f64 / CONE_EDGES as f64;
            let (sin, cos) = angle.sin_cos();
            &point.normal + friction * (cos * s + sin * t)
        }));
    }
    edges
}
