//! Sizing: from load, steel and displacement to a bearing, and whether it stands.
//!
//! [`Proposal`] goes through practical diameters by the rules of the reference study ([`Candidate`]);
//! `case_file` writes the chosen one; `verify` solves it at the centre and displaced, and holds
//! every part and every line of contact against its limit ([`DesignVerdict`]). `line` does the same for
//! parallel rollers.

mod assumption;
mod candidate;
mod case_file;
mod error;
mod line;
mod practical;
mod proposal;
mod request;
mod rows;
pub mod table;
mod verdict;
mod verify;

pub use assumption::SizingAssumption;
pub use candidate::{Candidate, Lengths, PressureSpread, STOUT};
pub use case_file::{Position, case_file};
pub use error::SizeError;
pub use line::{
    LineCandidate, LineProposal, LineRequest, LineVerdict, render_line, verify_line, write_line,
};
pub use practical::{diameters, rounded_up};
pub use proposal::Proposal;
pub use request::{LengthRule, Request, Setting, quantity, units_of_load};
pub use verdict::{
    Advice, DesignVerdict, LimitCheck, LimitKind, Placed, SizeStanding, render as render_verdict,
};
pub use verify::{Verification, verify, write};
