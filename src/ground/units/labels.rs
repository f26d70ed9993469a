//! Names of units, for reading only: nothing is ever converted here.

use super::UnitSystem;
use serde::Serialize;

/// What the case calls its units; figures come in these units.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct UnitLabels {
    pub length: String,
    pub force: String,
    pub stress: String,
}

impl UnitLabels {
    /// Labels from their names, such as `("in", "kip", "ksi")`.
    pub fn new(length: &str, force: &str, stress: &str) -> Self {
        Self {
            length: length.to_string(),
            force: force.to_string(),
            stress: stress.to_string(),
        }
    }

    /// Of a system of units.
    pub fn of(units: UnitSystem) -> Self {
        Self::new(units.length(), units.force(), units.stress())
    }

    pub fn area(&self) -> String {
        format!("{}²", self.length)
    }

    pub fn volume(&self) -> String {
        format!("{}³", self.length)
    }

    /// The unit of what is claimed, empty for a bare number.
    pub fn of_measure(&self, measure: Measure) -> String {
        match measure {
            Measure::Length => self.length.clone(),
            Measure::Area => self.area(),
            Measure::Force => self.force.clone(),
            Measure::LineLoad => self.line_load(),
            Measure::Stress => self.stress.clone(),
            Measure::Ratio => String::new(),
        }
    }

    /// Force per length.
    pub fn line_load(&self) -> String {
        format!("{}/{}", self.force, self.length)
    }
}

/// What a quantity is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    Length,
    Area,
    Force,
    LineLoad,
    Stress,
    Ratio,
}
