//! The dimensions of a bearing, of whichever template.

use std::ops::Deref;

use super::geometry::BearingGeometry;
use super::layout::Layout;
use super::line::LineGeometry;

/// The dimensions of a bearing: what all templates say of it is a [`Layout`].
#[derive(Debug, Clone, PartialEq)]
pub enum Dimensions {
    /// `[bearing]`: two crossed rollers between three plates.
    Crossed(BearingGeometry),
    /// `[line_bearing]`: parallel rollers between two plates.
    Line(LineGeometry),
}

impl Deref for Dimensions {
    type Target = dyn Layout;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Crossed(geometry) => geometry,
            Self::Line(geometry) => geometry,
        }
    }
}

impl Dimensions {
    /// Two crossed rollers.
    pub fn crossed(&self) -> Option<&BearingGeometry> {
        match self {
            Self::Crossed(geometry) => Some(geometry),
            Self::Line(_) => None,
        }
    }

    /// Parallel rollers.
    pub fn line(&self) -> Option<&LineGeometry> {
        match self {
            Self::Crossed(_) => None,
            Self::Line(geometry) => Some(geometry),
        }
    }
}
