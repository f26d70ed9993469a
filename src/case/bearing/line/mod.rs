//! `[line_bearing]`: parallel rollers between two plates.

mod curve;
mod geometry;
mod layout;
mod limits;
mod reader;
mod sizes;

pub use geometry::{LineGeometry, LinePlate, PlateCurve};
pub use limits::MOST_ROLLERS;
