//! The small types that a summary is put together from.

use serde::{Serialize, Serializer};

/// Counts of the solver.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
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
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
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

/// A figure of a reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Figure {
    Value(f64),
    /// Smallest and largest.
    Range([f64; 2]),
}

/// A figure of this run beside those of others.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Comparison {
    /// The quantity with its unit and measure, such as "Mises, centroid, ksi".
    pub what: String,
    /// Where in the bearing.
    #[serde(rename = "where")]
    pub place: String,
    /// What the reference study prints.
    pub report: Option<Figure>,
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

/// One value for each of the three ways to read a Mises peak.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Three<T> {
    pub centroid: T,
    pub integration_point: T,
    pub nodal: T,
}

impl<T: Copy> Three<T> {
    /// The three in the order of their printing.
    pub fn each(&self) -> [T; 3] {
        [self.centroid, self.integration_point, self.nodal]
    }
}

/// Named values in the order of the scene; an object in JSON.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Named<T>(pub Vec<(String, T)>);

impl<T: Serialize> Serialize for Named<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<T> Named<T> {
    /// The value called `name`.
    pub fn get(&self, name: &str) -> Option<&T> {
        self.0
            .iter()
            .find(|(n, _)| n == name)
            .map(|(_, value)| value)
    }
}
