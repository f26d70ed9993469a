//! The unknowns of a scene.

use crate::model::scene::Scene;
use crate::solver::fem::dofs::{DofMap, owners};
use crate::solver::fem::tied::{Joint, Tied};
use crate::solver::solve::error::SolveError;
use crate::solver::solve::ties::followers::followers;
use std::sync::Arc;

/// The components of `scene` that follow others.
///
/// # Errors
/// [`SolveError`] where supports contradict each other or surfaces cannot be tied.
pub fn tied(scene: &Scene) -> Result<Arc<Tied>, SolveError> {
    if scene.ties.is_empty() && scene.mesh.hanging.is_empty() {
        return Ok(Arc::default());
    }
    Ok(Arc::new(followers(scene, &owners(scene)?)?))
}

/// The equations of `scene`, whose ties are `tied`.
///
/// # Errors
/// [`SolveError`] where supports contradict each other.
pub fn equations(scene: &Scene, tied: Arc<Tied>) -> Result<DofMap, SolveError> {
    Ok(DofMap::new(scene, &owners(scene)?, tied))
}

/// How each tie of `scene` joins.
///
/// # Errors
/// [`SolveError`] where supports contradict each other or surfaces cannot be tied.
pub fn joints(scene: &Scene) -> Result<Vec<Joint>, SolveError> {
    Ok(tied(scene)?.joints.clone())
}

/// The number of unknowns of `scene`.
///
/// # Errors
/// [`SolveError`] where supports contradict each other or surfaces cannot be tied.
pub fn unknowns(scene: &Scene) -> Result<usize, SolveError> {
    Ok(equations(scene, tied(scene)?)?.len())
}
