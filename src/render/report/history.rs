//! What an iteration of the solution told, kept for the page.

/// One Newton iteration; all values relative where a tolerance is relative.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Iterate {
    /// Steps done at the load that the increment aims at: 1.5 is half of the second step.
    pub load: f64,
    pub iteration: usize,
    /// Residual force over applied force.
    pub residual: f64,
    /// Work of the residual on the correction over the work of the loads.
    pub energy: f64,
    /// Contact nodes that carry pressure, and how many of them stick and slip.
    pub active: usize,
    pub sticking: usize,
    pub slipping: usize,
    /// Contact nodes whose status changed.
    pub changed: usize,
    /// Largest violation of a contact condition, as a length over the largest displacement.
    pub violation: f64,
    /// Integration points that flow.
    pub flowing: usize,
    /// Directions of the linear solution, and whether a new factor was made.
    pub directions: usize,
    pub refactored: bool,
    /// Share of the correction that was taken.
    pub line_search: f64,
}
