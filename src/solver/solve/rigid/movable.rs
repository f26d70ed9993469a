//! Motions that supports, rigid planes and shared nodes leave to the bodies, whatever the contact.

use crate::model::scene::Scene;
use crate::solver::solve::params::MOVABLE_EIGENVALUE;
use crate::solver::solve::rigid::resistance::Resistance;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use nalgebra::{DMatrix, SymmetricEigen};

/// Motions of all bodies that supports, rigid planes and shared nodes leave, a column each; `None` where there are
/// none.
pub fn movable_modes(scene: &Scene, frames: &RigidBodies) -> Option<DMatrix<f64>> {
    let mut seen = Resistance::new(scene.mesh.bodies.len());
    seen.supports(scene, frames);
    seen.planes(scene, frames);
    seen.shared_nodes(frames);
    let eigen = SymmetricEigen::new(seen.matrix);
    let free = (0..eigen.eigenvalues.len()).filter(|i| eigen.eigenvalues[*i] < MOVABLE_EIGENVALUE);
    let columns: Vec<_> = free
        .map(|i| eigen.eigenvectors.column(i).into_owned())
        .collect();
    (!columns.is_empty()).then(|| DMatrix::from_columns(&columns))
}
