//! The bearings, and how much their elements are scaled for a number of unknowns.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Model {
    /// A quarter.
    Centre,
    /// Whole.
    Offset,
}

/// Unknowns of the preset h025 with every element `scale` times as large. Counts of elements are
/// whole numbers, so they come in steps.
type Known = [(f64, f64); 7];

const CENTRE: Known = [
    (10_079.0, 1.36),
    (24_525.0, 1.0),
    (52_137.0, 0.77),
    (100_831.0, 0.6),
    (200_845.0, 0.475),
    (406_628.0, 0.375),
    (1_002_553.0, 0.275),
];
const OFFSET: Known = [
    (11_329.0, 2.2),
    (26_917.0, 1.5),
    (52_669.0, 1.2),
    (103_690.0, 0.92),
    (198_175.0, 0.72),
    (429_625.0, 0.56),
    (1_030_846.0, 0.405),
];

impl Model {
    /// The case file, from the root of the repository.
    pub fn case(self) -> &'static str {
        match self {
            Self::Centre => "cases/section-2.6.2/initial-centre.toml",
            Self::Offset => "cases/large/displaced-million.toml",
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Centre => "centre",
            Self::Offset => "offset",
        }
    }

    pub fn words(self) -> &'static str {
        match self {
            Self::Centre => "rollers at the centre, a quarter",
            Self::Offset => "rollers 2.5 in off the centre, the whole",
        }
    }

    /// The scale that makes about `unknowns`: a power law between those that are known.
    pub fn scale(self, unknowns: f64) -> f64 {
        let known = match self {
            Self::Centre => CENTRE,
            Self::Offset => OFFSET,
        };
        // Sizes that are asked for by their round numbers get what is known.
        if let Some((_, scale)) = known.iter().find(|k| (k.0 / unknowns - 1.0).abs() < 0.14) {
            return *scale;
        }
        let upper = known.iter().position(|k| k.0 > unknowns);
        let upper = upper.unwrap_or(known.len() - 1).max(1);
        let [(n0, s0), (n1, s1)] = [known[upper - 1], known[upper]];
        let share = (unknowns / n0).ln() / (n1 / n0).ln();
        let scale = s0 * (s1 / s0).powf(share);
        (1e4 * scale).round() / 1e4
    }
}

/// About how many unknowns, and how that was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Size {
    pub label: String,
    pub unknowns: f64,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` is no number of unknowns, such as 25k or 1M");
        let number = text.trim_end_matches(['k', 'M']);
        let factor = match &text[number.len()..] {
            "" => 1.0,
            "k" => 1e3,
            "M" => 1e6,
            _ => return Err(wrong()),
        };
        let unknowns = factor * number.parse::<f64>().map_err(|_| wrong())?;
        if !(2e3..=3e6).contains(&unknowns) {
            return Err(format!("{text}: must lie between 2k and 3M"));
        }
        Ok(Self {
            label: text.into(),
            unknowns,
        })
    }
}
