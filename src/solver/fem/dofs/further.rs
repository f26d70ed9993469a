//! Displacement components that follow the turn of a rigid plane.

/// One share of a displacement component, beside that of its own equation: `lever` times the unknown of `equation`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Further {
    /// The node,
    pub node: u32,
    /// the axis (0, 1, 2),
    pub axis: usize,
    /// the equation of the turn, whose unknown is the angle times a length,
    pub equation: u32,
    /// and the displacement for an unknown of one, without unit.
    pub lever: f64,
}
