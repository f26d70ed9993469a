//! Hertz contact of two cylinders along a line, of spheres at a point, and over an ellipse.
//!
//! Common assumptions: smooth elastic half spaces, no friction, contact small against the radii
//! and the thickness of the bodies. `compliance` is C_E = 1/E* of
//! [`contact_compliance`](super::contact_compliance).

mod elliptic;
mod line;
mod point;
mod pressure;
mod radius;

pub use elliptic::EllipticContact;
pub use line::{LineContact, widening_in_flow};
pub use point::PointContact;
pub(crate) use pressure::semi_elliptic;
pub use radius::effective_radius;
