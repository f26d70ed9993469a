//! How a scene is solved: sparse algebra, finite elements, contact, and the strategy that joins them.

pub mod contact;
pub mod fem;
pub mod linear;
pub mod solve;
