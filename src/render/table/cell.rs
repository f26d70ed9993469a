//! What stands in a place of a table.

use crate::answer::certify::Figure;
use crate::render::figures::{DIGITS, POSITION_DIGITS};

/// A figure and what is known of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// None where there is no such figure.
    pub value: Option<f64>,
    /// Significant digits where no error says how many it is worth.
    pub digits: usize,
    /// Estimated, in the unit of the figure.
    pub error: Option<f64>,
    /// False where the certificate knows the figure and not its error.
    pub resolved: bool,
    /// Is it a peak beside a loaded edge, a value of this mesh? Such are marked by a star.
    pub at_edge: bool,
}

/// A cell knows what it is, so that each backend can write it in its own way.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    Text(String),
    /// Words that ask for care.
    Care(String),
    /// A figure. Its error stands in the certificate, so that the terminal leaves it out here.
    Figure(Number),
    /// A figure that has its error beside it everywhere.
    Estimate(Number),
    /// As small as rounding makes it: its power of ten is what counts.
    Tiny(f64),
    /// A part of a whole, 1 for all of it.
    Share(Option<f64>),
    /// How far off something is, relative to it: a share of two digits, none where it is rounding.
    Off(Option<f64>),
    Count(usize),
    /// Is a limit met? None where there is none.
    Met(Option<bool>),
    /// A place in the case's coordinates.
    Place(Option<[f64; 3]>),
}

impl Cell {
    /// A figure of which no error is known.
    pub fn figure(value: impl Into<Option<f64>>) -> Self {
        Self::Figure(Number::new(value, DIGITS))
    }

    /// A figure of fewer digits: a position, a length or a strain.
    pub fn rough(value: impl Into<Option<f64>>) -> Self {
        Self::Figure(Number::new(value, POSITION_DIGITS))
    }

    /// A figure that the certificate may know as `claim`.
    pub fn certified(value: impl Into<Option<f64>>, claim: Option<&Figure>) -> Self {
        Self::Figure(Number {
            error: claim.and_then(Figure::bar),
            resolved: claim.is_none_or(Figure::is_resolved),
            ..Number::new(value, DIGITS)
        })
    }

    /// A component of a force, as zero where it is noise beside the whole.
    pub fn component(component: f64, whole: f64) -> Self {
        /// Components below this share of the whole are rounding.
        const NOISE: f64 = 1e-9;
        let noise = component.abs() <= NOISE * whole.abs();
        Self::figure(if noise { 0.0 } else { component })
    }
}

impl Number {
    /// A figure of so many digits, of which no error is known.
    pub fn new(value: impl Into<Option<f64>>, digits: usize) -> Self {
        Self {
            value: value.into(),
            digits,
            error: None,
            resolved: true,
            at_edge: false,
        }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_string())
    }
}

impl From<&String> for Cell {
    fn from(text: &String) -> Self {
        Self::Text(text.clone())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}
