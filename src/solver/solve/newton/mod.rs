//! Newton's method with augmented Lagrange and a primal-dual active set, for one increment.
//!
//! Start with [`balance`].

pub mod active_set;
pub mod balance;
pub mod failure;
pub mod friction_bounds;
pub mod goal;
pub mod line_search;
pub mod progress;
pub mod proximal_point;
pub mod rounding;
pub mod violation;
