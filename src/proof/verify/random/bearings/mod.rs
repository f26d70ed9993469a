//! Random bearings, and what is known of each without solving it.

mod draw;
mod statics;

pub use draw::draw;
