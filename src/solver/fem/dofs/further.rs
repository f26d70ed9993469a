//! Displacement components that hang on more than an equation of their own: turns of rigid planes, ties.

/// One share of a displacement component, beside that of its own equation: `lever` times the unknown of `equation`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Further {
    /// The node,
    pub node: u32,
    /// the axis (0, 1, 2),
    pub axis: usize,
    /// the equation: of a turn, whose unknown is the angle times a length, or of a component that this one follows by a tie,
    pub equation: u32,
    /// and the displacement for an unknown of one, without unit.
    pub lever: f64,
}
