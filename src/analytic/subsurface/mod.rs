//! Stresses inside the bodies of a Hertz contact, their peaks and first yield.
//!
//! x runs across the contact (for an ellipse: along the long axis), y along the roller, z into
//! the body.

pub mod ellipse;
pub mod line;
pub mod onset;
pub mod sphere;

pub use ellipse::EllipseField;
pub use line::LineField;
pub use sphere::SphereField;

/// Place and value of a peak stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The stress.
    pub value: f64,
    /// Distance x from the centre line.
    pub x: f64,
    /// Depth z below the surface.
    pub depth: f64,
}
