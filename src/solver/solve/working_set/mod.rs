//! Working-set prediction: which contact rows and elements have to be kept, and whether that was enough.

pub mod flow;
pub mod overlap;
pub mod shares_of_yield;
pub mod unforeseen;
