//! Load steps.

use serde::Serialize;

/// One step: loads and prescribed displacements move linearly to these factors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// What messages and results call it.
    pub name: String,
    /// Factor at the end of the step for every support, plane and traction not named below.
    pub factor: f64,
    /// Factors by name of support, plane or traction.
    pub factors: Vec<(String, f64)>,
}

impl Step {
    /// The step called `name`, in which everything moves to `factor`.
    pub fn to(name: impl Into<String>, factor: f64) -> Self {
        Self {
            name: name.into(),
            factor,
            factors: Vec::new(),
        }
    }

    /// The factor that the support, plane or traction called `name` has at the end of the step.
    pub fn factor_of(&self, name: &str) -> f64 {
        let own = self.factors.iter().find(|(n, _)| n == name);
        own.map_or(self.factor, |(_, factor)| *factor)
    }
}
