//! The sections of the page, a file each. An empty one says nothing and is left out.

pub mod bodies;
pub mod certificate;
pub mod compared;
pub mod contact;
pub mod convergence;
pub mod depth;
pub mod input;
pub mod line_load;
pub mod loading;
pub mod pictures;
pub mod pressure_map;
pub mod run;
pub mod sizing;
pub mod space;
pub mod strip;
pub mod utilisation;
pub mod verdict;
