//! What users ask for: one case, many of them, a size, a goal, a series of meshes.

#[doc(hidden)]
pub mod combinations;
#[doc(hidden)]
pub mod converge;
#[doc(hidden)]
pub mod deck;
pub mod job;
#[doc(hidden)]
pub mod print;
#[doc(hidden)]
pub mod size;
#[doc(hidden)]
pub mod sweep;
#[doc(hidden)]
pub mod target;
