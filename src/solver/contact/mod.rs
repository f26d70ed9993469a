//! Contact between surfaces: where they face each other, how they press and rub.
//!
//! Of the two sides of a pair one is the *carrier*: the literature's non-mortar or slave side. Each
//! of its nodes has a multiplier, the contact traction there. The *opposite* side is the mortar or
//! master side: a surface of another body, or a rigid plane.
//!
//! A pair is integrated once, on the undeformed geometry, over the segments in which facets of both
//! sides overlap; displacements are small, as everywhere in Brinell. What is left for each iteration
//! is a constant sparse operator ([`mortar`]) and a law at each carrier node ([`law`]).

pub mod facing;
pub mod law;
pub mod mortar;
pub mod search;
pub mod tie;

mod bend;
mod clip;
mod facet;
mod gathered;
mod gauss;
mod node_sum;
mod pair;
mod piece;
mod projection;
mod row;
mod segment;
mod side;
mod sight;
mod sliver;
mod viewer;
