//! Ties of a scene: which displacement components follow which others.

pub mod error;
pub mod followers;
pub mod order;
pub mod sides;
pub mod touching;
pub mod unknowns;
