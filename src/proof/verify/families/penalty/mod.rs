//! The answer does not depend on the penalty of the contact.
//!
//! The penalty is the slope of an augmented Lagrangian, so a hundred times more or less of it must
//! leave every figure where it is. What may move is bounded by the tolerances of the increment.

mod bearing;
mod line;
mod problem;

pub use bearing::claims as claims_of_bearing;
pub use line::claims;
