//! The verification ladder: problems with known answers, and how far off Brinell is.
//!
//! `families` lists the claims and measures them; [`matrix`] prints them. [`extreme`] and [`random`] ask whether
//! cases are solved or rightly refused, [`coverage`] whether error bars hold.

mod claim;
pub mod coverage;
mod drawn;
mod error;
mod extent;
pub mod extreme;
mod families;
pub mod kit;
pub mod matrix;
pub mod random;
mod scenes;
pub mod stability;
pub mod stream;

pub use claim::LadderClaim;
pub use error::VerifyError;
pub use extent::Extent;
pub use families::{ClaimFamily, FAMILIES, families};
pub use scenes::problem_h;
