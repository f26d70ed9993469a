//! The systems of units that the handbook answers in.

use clap::ValueEnum;
use serde::Serialize;

/// A consistent system of units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize)]
pub enum HandbookUnits {
    /// inch, kip, ksi
    #[value(name = "in-kip-ksi")]
    #[serde(rename = "in-kip-ksi")]
    InKipKsi,
    /// millimetre, newton, megapascal
    #[value(name = "mm-N-MPa")]
    #[serde(rename = "mm-N-MPa")]
    MmNMpa,
    /// metre, newton, pascal
    #[value(name = "m-N-Pa")]
    #[serde(rename = "m-N-Pa")]
    MNPa,
}

impl HandbookUnits {
    /// Names of length, force and stress.
    pub fn names(self) -> [&'static str; 3] {
        match self {
            HandbookUnits::InKipKsi => ["in", "kip", "ksi"],
            HandbookUnits::MmNMpa => ["mm", "N", "MPa"],
            HandbookUnits::MNPa => ["m", "N", "Pa"],
        }
    }

    /// Young's modulus of the reference study's steel, 29500 ksi.
    pub fn steel_modulus(self) -> f64 {
        match self {
            HandbookUnits::InKipKsi => 29500.0,
            HandbookUnits::MmNMpa => 29500.0 * 6.894757293168361,
            HandbookUnits::MNPa => 29500.0 * 6.894757293168361e6,
        }
    }
}
