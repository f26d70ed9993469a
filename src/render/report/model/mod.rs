//! The solved model as the page shows it: cut by planes, and packed for the view in space.

pub mod pack;
pub mod shape;
pub mod slice;
