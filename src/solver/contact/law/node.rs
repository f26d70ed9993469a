//! What a carrier node is and remembers, and what its law answers.

use serde::{Deserialize, Serialize};

/// Is the node open, does it stick, does it slip?
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Status {
    #[default]
    Open,
    Stick,
    /// Sliding; without friction every closed node does.
    Slip,
}

/// What changes at a node from iteration to iteration. Symbols as in [`super`].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Node {
    /// Is it in the set of closed nodes,
    pub closed: bool,
    /// and in that of sticking ones? Not asked of an open node.
    pub sticks: bool,
    /// λ: pressure and two shears.
    pub multiplier: [f64; 3],
    /// Coulomb's bound on the shear: μ p, p being the pressure of the iteration before.
    pub bound: f64,
    /// The linearised shear of a slipping node is λ + `slope` (d − `origin`), tangential parts only.
    pub origin: [f64; 2],
    /// ∂z/∂d of the tangential part.
    pub slope: [[f64; 2]; 2],
    /// Is friction treated with caution here: by radial return, not by sets?
    pub cautious: bool,
    /// How often it changed between stick and slip in this increment.
    pub switches: u8,
    /// By how many powers of ten ε_t has been raised: where λ came nearer its value too slowly, and
    /// where the sets have settled.
    pub raised: u8,
    /// By how many powers of ten ε has been raised, where contact closed too slowly.
    pub firmer: u8,
    /// How far λ was off when it took the shear last, as a length.
    pub missed: f64,
}

/// The traction z at a node, and its derivative ∂z/∂d.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NodeResponse {
    /// z: pressure and two shears.
    pub traction: [f64; 3],
    /// ∂z/∂d, symmetric.
    pub tangent: [[f64; 3]; 3],
    /// Is the node open, does it stick, does it slip?
    pub status: Status,
}
