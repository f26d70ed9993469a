//! The solved model as the page shows it: packed for the view in space.

pub mod pack;
pub mod shape;
