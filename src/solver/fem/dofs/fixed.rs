//! Components without an equation.

/// Marks a component without an equation.
pub const FIXED: u32 = u32::MAX;
