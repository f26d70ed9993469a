//! Motions that supports, rigid planes and shared nodes leave to the bodies, whatever the contact.

use crate::model::scene::Scene;
use crate::solver::solve::params::MOVABLE_EIGENVALUE;
use crate::solver::solve::rigid::resistance::Resistance;
use crate::solver::solve::rigid::rigid_bodies::RigidBodies;
use nalgebra::{DMatrix, DVector};

/// Bodies that can move, and what the loads do to the motions left to them.
pub struct Movable {
    pub bodies: RigidBodies,
    /// Motions that are left, a column each: six numbers a body.
    pub modes: DMatrix<f64>,
    /// Work of the loads on each of them; not zero.
    pub load: DVector<f64>,
}

impl Movable {
    /// Of `scene` under loads of these `factors`, by name; `None` where nothing can move or nothing drives it.
    pub fn new(scene: &Scene, factors: &dyn Fn(&str) -> f64) -> Option<Self> {
        let bodies = RigidBodies::new(scene);
        let modes = movable_modes(scene, &bodies)?;
        let load = modes.tr_mul(&DVector::from_vec(bodies.load(scene, factors)));
        (load.norm() != 0.0).then_some(Self {
            bodies,
            modes,
            load,
        })
    }
}

/// Motions of all bodies that supports, rigid planes and shared nodes leave, a column each; `None` where there are
/// none.
fn movable_modes(scene: &Scene, bodies: &RigidBodies) -> Option<DMatrix<f64>> {
    let mut seen = Resistance::new(scene.mesh.bodies.len());
    seen.supports(scene, bodies);
    seen.planes(scene, bodies);
    seen.half_turn(scene, bodies);
    seen.ties(scene, bodies);
    seen.shared_nodes(bodies);
    let modes = seen.unresisted(MOVABLE_EIGENVALUE);
    (!modes.is_empty()).then(|| DMatrix::from_columns(&modes))
}
