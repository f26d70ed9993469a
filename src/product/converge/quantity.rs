//! What is read from every level.

use serde::Serialize;

/// A value from elsewhere.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Known {
    pub value: f64,
    /// How far it may be off, relative to itself: smaller errors mean nothing. Zero where exact.
    pub within: f64,
    pub origin: &'static str,
}

/// One scalar of one level.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyQuantity {
    pub name: String,
    pub unit: String,
    pub value: f64,
    pub known: Option<Known>,
    /// Is it a peak beside a loaded edge, where elastic stress has no limit?
    pub at_singular_edge: bool,
}
