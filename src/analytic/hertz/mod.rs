//! Hertz contact of two cylinders along a line.
//!
//! Common assumptions: smooth elastic half spaces, no friction, contact small against the radii
//! and the thickness of the bodies. `compliance` is C_E = 1/E* of
//! [`contact_compliance`](super::contact_compliance).

mod line;
mod pressure;
mod radius;

pub use line::LineContact;
pub(crate) use pressure::semi_elliptic;
pub use radius::effective_radius;
