//! Cells of the tables of the study.

use super::quantities::RowReading;
use crate::render::summary::{Comparison, Reported};
use crate::render::text::significant;

/// Digits of a printed value.
pub const DIGITS: usize = 4;

/// A figure with its error.
pub fn cell(reading: Option<RowReading>) -> String {
    match reading {
        None => "-".to_owned(),
        Some(RowReading { value, error: None }) => significant(value, DIGITS),
        Some(RowReading {
            value,
            error: Some(error),
        }) => format!("{} ± {}", significant(value, DIGITS), significant(error, 2)),
    }
}

/// What the study prints of a quantity.
pub fn printed(row: &Comparison) -> Option<f64> {
    match row.report {
        Some(Reported::Value(value)) => Some(value),
        _ => None,
    }
}
