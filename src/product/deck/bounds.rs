//! The size of a model.

use crate::model::scene::Scene;

/// Diagonal of the box around the model.
pub fn diagonal(scene: &Scene) -> f64 {
    (0..3)
        .map(|axis| scene.mesh.extent(axis).powi(2))
        .sum::<f64>()
        .sqrt()
}
