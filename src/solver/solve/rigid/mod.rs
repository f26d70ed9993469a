//! Rigid-body modes: which motions of the bodies nothing resists, and where floating bodies come to rest.
//!
//! Six unknowns a body say in hundredths of a second what a solution of the deformable bodies would find at length, or not
//! at all.

pub mod foundation;
pub mod free_motion;
pub mod load;
pub mod movable;
pub mod resistance;
pub mod rest;
pub mod rigid_bodies;
pub mod touch;
