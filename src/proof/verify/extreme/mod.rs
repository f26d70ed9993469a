//! Cases at the edge of what can be solved, each with what is expected of it: a checked value, or a
//! refusal with a named diagnosis.
//!
//! A suite is a TOML file beside its cases. Each entry takes a base case, changes some of its keys,
//! and says what must come of it; it is run as a user's case is, from its text to its summary.

mod entry;
mod outcome;
mod page;
mod run;
mod suite;

pub use entry::Extreme;
pub use outcome::{ExtremeOutcome, ExtremeVerdict};
pub use page::{head, line, section};
pub use suite::{SuiteError, read};
