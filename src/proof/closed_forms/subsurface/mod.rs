//! Stresses on the axis of a point or elliptic contact, their peaks and first yield.
//!
//! x runs along the long axis of an ellipse, z into the body.

pub mod ellipse;
pub mod onset;
pub mod sphere;

pub use ellipse::EllipseField;
pub use sphere::SphereField;
