//! Contact between surfaces: where they face each other, how they press and rub.
//!
//! The pair is integrated once, on the undeformed geometry, over the segments in which the
//! facets of the two sides overlap (small displacements, as everywhere in Brinell). What is left
//! for every iteration is a constant sparse operator and a law at each carrier node.

pub mod clip;
pub mod facing;
pub mod law;
pub mod mortar;
mod piece;
pub mod search;
pub mod segment;
mod side;
mod sliver;
