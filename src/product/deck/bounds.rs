//! The size of a model.

use crate::model::scene::Scene;

/// Diagonal of the box around the model.
pub fn diagonal(scene: &Scene) -> f64 {
    (0..3)
        .map(|axis| span(scene, axis).powi(2))
        .sum::<f64>()
        .sqrt()
}

/// Length of the box around the model along `axis`.
pub fn span(scene: &Scene, axis: usize) -> f64 {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let points = scene.mesh.points.iter();
    let (low, high) = points.fold(ends, |(l, h), p| (l.min(p[axis]), h.max(p[axis])));
    high - low
}
