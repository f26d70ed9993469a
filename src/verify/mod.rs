//! The verification ladder: problems with known answers, and how far off Brinell is.

pub mod claim;
pub mod energy;
mod error;
pub mod kit;
pub mod problem_h;

pub use claim::Claim;
pub use error::VerifyError;
