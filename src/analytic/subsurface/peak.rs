//! A peak below the surface.

/// Place and value of a peak stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakStress {
    /// The stress.
    pub value: f64,
    /// Distance x from the centre line.
    pub x: f64,
    /// Depth z below the surface.
    pub depth: f64,
}
