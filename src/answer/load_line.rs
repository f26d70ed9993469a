//! Descent against load.

use super::steps::StepFigures;
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

/// One point for each of the steps.
pub fn points(steps: &[StepFigures]) -> Vec<LoadPoint> {
    let point = |step: &StepFigures| LoadPoint {
        step: step.name.clone(),
        load: step.load,
        descent: step.descent,
    };
    steps.iter().map(point).collect()
}
