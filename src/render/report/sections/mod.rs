//! The sections of the page, a file each. An empty one says nothing and is left out.

pub mod convergence;
pub mod depth;
mod drawing;
pub mod input;
pub mod line_load;
mod line_sketch;
pub mod model;
pub mod pictures;
pub mod pressure_map;
pub mod run;
pub mod scope;
pub mod sketch;
pub mod space;
pub mod strip;
pub mod title_block;
pub mod verdict;
pub mod verified;
