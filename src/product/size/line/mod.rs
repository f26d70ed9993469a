//! Parallel rollers between two plates: from load and steel to their number, diameter and length, and whether they stand.
//!
//! The load is spread evenly over the lines of contact, times a margin, and Hertz's p0 kept within its limit; what bends
//! and what ends do is for the verdict, which solves the bearing.

mod candidate;
mod case_file;
mod proposal;
mod request;
mod table;
mod verify;

pub use candidate::LineCandidate;
pub use proposal::LineProposal;
pub use request::LineRequest;
pub use table::render as render_line;
pub use verify::{LineVerdict, verify as verify_line, write as write_line};
