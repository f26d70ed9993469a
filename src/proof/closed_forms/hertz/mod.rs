//! Hertz contact at a point and over an ellipse.
//!
//! Assumptions and `compliance` as in [`hertz`](crate::analytic::hertz) of a line.

mod elliptic;
mod point;

pub use elliptic::EllipticContact;
pub use point::PointContact;
