//! What `brinell check` finds out about a case before it is solved.

mod table;

use crate::ground::units::UnitLabels;
use serde::Serialize;

pub use table::render;

/// A case and its mesh, looked at but not solved. Figures are in the units of the case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    pub case: String,
    pub units: UnitLabels,
    pub mesh: MeshCheck,
    pub bodies: Vec<BodyCheck>,
    pub contacts: Vec<ContactCheck>,
    /// Lines of contact, where Hertz's half-width can be told beforehand.
    pub strips: Vec<StripCheck>,
    pub cost: PredictedCost,
    pub machine: Machine,
    /// What the solution has to do, in words.
    pub needs: Vec<String>,
    /// What it can do without.
    pub left_out: Vec<String>,
    pub assumptions: Vec<String>,
    /// What the answer will be held to.
    pub limits: Vec<String>,
    pub warnings: Vec<String>,
    /// Why a run of it would fail; empty where nothing was found.
    pub problems: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeshCheck {
    /// The file, or how the mesh came about.
    pub source: String,
    pub nodes: usize,
    pub elements: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyCheck {
    pub name: String,
    pub elements: usize,
    pub nodes: usize,
    /// Of the modelled part.
    pub volume: f64,
    /// Smallest scaled Jacobian at any corner: 1 for boxes.
    pub min_scaled_jacobian: f64,
    /// Largest ratio of the longest to the shortest edge of an element.
    pub max_aspect_ratio: f64,
    /// Supports, rigid planes and contacts on the body, in words.
    pub held_by: Vec<String>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactCheck {
    pub name: String,
    pub friction: f64,
    /// Least gap as meshed, open positive; `None` where the sides do not face each other.
    pub gap: Option<f64>,
    /// The same once floating bodies have been moved into touch.
    pub gap_at_touch: Option<f64>,
    /// Where that is.
    pub at: Option<[f64; 3]>,
    /// Contact nodes that are likely to close, and all within reach.
    pub likely: usize,
    pub within_reach: usize,
}

/// A line of contact under the load spread evenly along it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StripCheck {
    pub contact: String,
    /// Lines like this one.
    pub lines: usize,
    /// Force normal to the surface, per length.
    pub line_load: f64,
    /// Hertz's half-width a and peak pressure p0.
    pub half_width: f64,
    pub peak_pressure: f64,
    /// Distance h of the carrier's nodes across the line.
    pub spacing: f64,
    /// a / h.
    pub elements: f64,
    /// Expected error of the peak pressure, (h/a)²/4; `None` where no node lies inside.
    pub pressure_error: Option<f64>,
}

/// What the solution will take; seconds are rough.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PredictedCost {
    pub unknowns: usize,
    /// Unknowns that contact acts on: iterations cannot do without them.
    pub contact_unknowns: usize,
    /// In words.
    pub solver: &'static str,
    pub memory_bytes: f64,
    pub iterations: f64,
    pub processor_s: f64,
    /// Least and most seconds on the clock.
    pub wall_s: [f64; 2],
}

#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Machine {
    pub threads: usize,
    /// `None` where the system does not tell.
    pub memory_bytes: Option<f64>,
}
