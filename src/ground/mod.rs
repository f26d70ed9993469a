//! What everything stands on and what knows nothing of mechanics: vectors, quantities with units, files, memory.

pub mod file;
pub mod geometry;
pub(crate) mod hash;
pub(crate) mod input;
pub mod markdown;
pub mod memory;
pub(crate) mod order;
pub mod units;
