//! The sets of bearings: ten by name, and those that a seed draws of either template.

use super::bearing::Bearing;
use super::{draw, draw_lines};
use std::fmt;

/// A set of bearings, whose references are in one file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Set {
    Named,
    Drawn(u64),
    /// Of parallel rollers.
    DrawnLines(u64),
}

impl Set {
    pub fn bearings(self) -> Vec<Bearing> {
        match self {
            Self::Named => named(),
            Self::Drawn(seed) => draw::bearings(seed),
            Self::DrawnLines(seed) => draw_lines::bearings(seed),
        }
    }
}

impl fmt::Display for Set {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Named => f.write_str("named"),
            Self::Drawn(seed) => write!(f, "seed-{seed}"),
            Self::DrawnLines(seed) => write!(f, "lines-{seed}"),
        }
    }
}

macro_rules! bearings {
    ($($name:literal),*) => {
        vec![$(($name, include_str!(concat!("../../../../cases/coverage/", $name, ".toml")))),*]
    };
}

/// From 1.5 to 8 in across, thin walls to solid ones, slopes of 1 to 8 degrees, the three ends, three of
/// them displaced.
fn named() -> Vec<Bearing> {
    let named = bearings![
        "centre",
        "displaced",
        "fillet-small",
        "thin-wall",
        "solid-heavy",
        "crowned-steep",
        "solid-small",
        "fillet-displaced",
        "hard-steel",
        "crowned-displaced"
    ];
    let bearing = |(name, text): (&str, &str)| Bearing {
        name: name.to_owned(),
        text: text.to_owned(),
    };
    named.into_iter().map(bearing).collect()
}
