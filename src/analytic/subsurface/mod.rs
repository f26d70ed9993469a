//! Stresses inside the bodies of a line contact, their peak and first yield; on the axis of a point or elliptic one.
//!
//! x runs across a line contact, y along the roller, z into the body; of an ellipse x runs along its long axis.

pub mod ellipse;
pub mod line;
pub mod onset;
mod peak;
pub mod sphere;

pub use ellipse::EllipseField;
pub use line::LineField;
pub use peak::PeakStress;
pub use sphere::SphereField;
