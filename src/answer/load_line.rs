//! Descent against load.

use crate::answer::results::load;
use crate::model::scene::Scene;
use crate::model::state::State;
use serde::Serialize;

/// The end of a step.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct LoadPoint {
    /// Its name.
    pub step: String,
    /// Size of the load that acts there.
    pub load: f64,
    /// Travel of the loaded plane along the load.
    pub descent: Option<f64>,
}

/// One point for each of `states`, which are at the ends of steps.
pub fn points(scene: &Scene, states: &[State]) -> Vec<LoadPoint> {
    let point = |state: &State| LoadPoint {
        step: scene
            .steps
            .get(state.step)
            .map_or_else(String::new, |step| step.name.clone()),
        load: load::applied(scene, state),
        descent: load::descent(scene, state),
    };
    states.iter().map(point).collect()
}
