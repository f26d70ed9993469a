//! Differences of temperature, and the strain that is free of stress under them.

use crate::ground::geometry::{Vec3, dot};
use serde::Serialize;

/// By how much a body is warmer than where it is free of stress: by `value` at its middle, changing linearly across it.
///
/// A small element that nothing holds stretches alike along all axes, by the coefficient of expansion times the
/// difference of temperature. The steel stays the same.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Temperature {
    /// What steps and messages call it.
    pub name: String,
    /// The body of the mesh.
    pub body: String,
    /// Coefficient of thermal expansion of its steel, per kelvin.
    pub expansion: f64,
    /// Difference in the [middle](crate::model::mesh::Mesh::middle_of_body) of the body, in kelvin (times the factor
    /// of the step).
    pub value: f64,
    /// Its change along x, y and z, kelvin per length (times the factor of the step).
    pub gradient: Vec3,
}

impl Temperature {
    /// The strain along every axis at `arm` from the middle of the body, at factor one.
    pub fn strain(&self, arm: Vec3) -> f64 {
        self.expansion * (self.value + dot(self.gradient, arm))
    }
}
