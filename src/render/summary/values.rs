//! The small types that a summary is put together from.

use crate::answer::Named;
use serde::Serialize;

/// Counts of the solver.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct Counters {
    pub dofs: usize,
    pub iterations: usize,
    pub factorisations: usize,
    /// Directions of the Krylov method, each a product with the matrix and a solution with a factor.
    pub krylov_directions: usize,
    /// Unknowns that the Newton iterations see, the others being eliminated beforehand.
    pub kept_dofs: usize,
    /// Entries of the factors that are held at the end.
    pub factor_entries: usize,
}

/// Seconds on the clock; those with `cpu` in their names are of all threads of the process together.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Timing {
    /// Reading or making the mesh, and the scene from it.
    pub mesh_s: f64,
    pub solve_s: f64,
    /// Not known on every system.
    pub solve_cpu_s: Option<f64>,
    /// Fields of the increments to their files, with recovering them.
    pub write_s: f64,
    /// Solving once more without plasticity.
    pub elastic_s: f64,
    pub total_s: f64,
    /// What `solve_s` went into.
    pub phases: Named<f64>,
}

/// An elastic solution beside the case, on a mesh of its own.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct ElasticTwin {
    /// Folder of its files, beside that of the case.
    pub folder: String,
    pub dofs: usize,
}

/// A figure of a reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum Reported {
    Value(f64),
    /// Smallest and largest.
    Range([f64; 2]),
}

/// A figure of this run beside those of others.
#[derive(Debug, Clone, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Comparison {
    /// The quantity with its unit and measure, such as "Mises, centroid, ksi".
    pub what: String,
    /// Where in the bearing.
    #[serde(rename = "where")]
    pub place: String,
    /// What the reference study prints.
    pub report: Option<Reported>,
    /// The same quantity on the report-like mesh.
    pub report_like: Option<f64>,
    /// This run.
    pub value: Option<f64>,
    /// Estimated error of `value`, in its unit.
    pub error: Option<f64>,
    /// Is the error known, of a figure that is certified?
    pub resolved: Option<bool>,
    /// Hertz's figure for the same load.
    pub hertz: Option<f64>,
}
