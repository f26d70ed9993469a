//! How a scene is solved: sparse algebra, finite elements, contact, and the strategy that joins them.

#[doc(hidden)]
pub mod contact;
#[doc(hidden)]
pub mod fem;
#[doc(hidden)]
pub mod linear;
pub mod solve;
