//! Numerical controls: tolerances, increments, element, linear solver.

use serde::Serialize;

/// Numerical controls, all relative and without units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Controls {
    /// Residual force relative to the applied force.
    pub residual: f64,
    /// Largest violation of a contact condition relative to the largest displacement, rigid travel included.
    pub penetration: f64,
    /// First increment, as a share of a step.
    pub first_increment: f64,
    /// Smallest increment, as a share of a step.
    pub smallest_increment: f64,
    /// Newton iterations an increment may take before it is cut back.
    pub iterations: usize,
    /// Solve once more in increments twice as large, where something yields, for what the increments are
    /// worth?
    pub increment_error: bool,
    /// Integrate plasticity? `false` keeps every body elastic.
    pub plasticity: bool,
    /// The hexahedron that all bodies are made of.
    pub element: ElementKind,
    /// How linear systems are solved.
    pub solver: SolverKind,
    /// Solve one half of a scene that is its own image under a half turn?
    pub half_turn: bool,
    /// Times the initial gap up to which contact is integrated at first. The answer does not depend on
    /// it, as contact is found wherever bodies meet: that is what it is there to prove.
    pub contact_reach: f64,
}

/// How linear systems are solved. The answer does not depend on it; time and memory do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum SolverKind {
    /// Whichever should be quicker.
    #[default]
    Auto,
    /// Bodies condensed onto contact and plastic flow, and a factor of what is left.
    Direct,
    /// A factor of each of many small parts and conjugate directions: the least memory.
    Divided,
}

/// A formulation of the eight-node hexahedron.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum ElementKind {
    /// Element-mean volumetric strain: "C3D8" of Abaqus. Robust, but stiff in bending.
    #[default]
    Bbar,
    /// Plain and fully integrated: "C3D8" of CalculiX. For comparison: stiffer still, and it locks
    /// in plastic flow.
    Full,
    /// Incompatible modes, as in "C3D8I": bends exactly where it is a brick.
    Enhanced,
}

impl Controls {
    /// What residuals, penetrations and increments have to be, in words.
    pub const SHARE: &str = "more than 0 and at most 1";

    /// Is a number such a share? Nothing that is no number is.
    pub fn is_share(value: f64) -> bool {
        value > 0.0 && value <= 1.0
    }
}

impl Default for Controls {
    fn default() -> Self {
        Self {
            residual: 1e-8,
            penetration: 1e-8,
            first_increment: 0.25,
            smallest_increment: 1e-4,
            iterations: 40,
            increment_error: true,
            plasticity: true,
            element: ElementKind::default(),
            solver: SolverKind::default(),
            half_turn: true,
            contact_reach: 1.0,
        }
    }
}
