//! Before the first increment: lengths of a scene, floating bodies in touch, what is expected to happen.

pub mod can_yield;
pub mod close_gaps;
pub mod expected;
pub mod extent;
pub mod held_bodies;
pub mod load_direction;
pub mod load_names;
pub mod nearest_row;
pub mod overlap;
