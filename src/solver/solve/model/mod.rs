//! The scene, discretised and condensed: what Newton's method iterates on.

pub mod displacement;
pub mod free_strains;
pub mod loads;
pub mod places;
pub mod prepare;
pub mod settled;
pub mod structure;
pub mod system;
pub mod thermal;
