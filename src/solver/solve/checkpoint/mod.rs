//! All that is serialised of a solution.
//!
//! A checkpoint is a [`restart::Restart`]; the other files are its parts. They are plain data, written by postcard: fields
//! keep their order. How they are made and taken up again is told where the solution runs, in
//! `increments/save.rs` and `increments/restore.rs`.

pub mod companion;
pub mod counters;
pub mod effort;
pub mod expected;
pub mod increment_plan;
pub mod kept;
pub mod packed;
pub mod plastic;
pub mod point;
pub mod restart;
pub mod timers;
