//! Displacement components whose values are given.

/// A displacement component whose value is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The node,
    pub node: u32,
    /// the axis (0, 1, 2),
    pub axis: usize,
    /// the displacement at factor one, a length,
    pub value: f64,
    /// and what prescribes it.
    pub source: Source,
}

/// The entry of the scene that prescribes a component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A support, by its index in the scene.
    Support(usize),
    /// A rigid plane, by its index in the scene.
    Plane(usize),
}
