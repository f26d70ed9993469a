//! What users ask for: one case, many of them, a size, a goal, a series of meshes.

pub mod converge;
pub mod deck;
pub mod job;
pub mod size;
pub mod sweep;
pub mod target;
