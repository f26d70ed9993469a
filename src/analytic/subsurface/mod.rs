//! Stresses inside the bodies of a line contact, their peak and first yield.
//!
//! x runs across the contact, y along the roller, z into the body.

pub mod line;
pub mod onset;
mod peak;

pub use line::LineField;
pub use peak::PeakStress;
