//! What half spaces say of the peak of a body.

use crate::ground::geometry::Vec3;

/// What is known of the largest Mises stress below the strips on a body, away from singular edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BelowStrips {
    /// The pair of the strip.
    pub pair: usize,
    /// The largest Mises stress.
    pub mises: f64,
    /// Root mean square of the Mises stress of what the rest of the stress does besides changing evenly.
    pub uneven: f64,
    /// By how much the rest changes the stress of the half space of the strip alone.
    pub by_rest: f64,
    /// How much larger it may be at the surface where friction turns round, from row to row along the strip or in its middle across it:
    /// there stress rises with the logarithm of the distance, and neither nodes nor half spaces show it.
    pub by_turn: f64,
    /// On the surface above it.
    pub at: Vec3,
    /// Does the strip carry up to an edge? There the stress may be larger.
    pub at_edge: bool,
}
