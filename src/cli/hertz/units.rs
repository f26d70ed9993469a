//! The systems of units that the handbook answers in.

use clap::ValueEnum;
use serde::Serialize;

/// A consistent system of units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Serialize)]
pub enum Units {
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

impl Units {
    /// Names of length, force and stress.
    pub fn names(self) -> [&'static str; 3] {
        match self {
            Units::InKipKsi => ["in", "kip", "ksi"],
            Units::MmNMpa => ["mm", "N", "MPa"],
            Units::MNPa => ["m", "N", "Pa"],
        }
    }

    /// Young's modulus of the reference study's steel, 29500 ksi.
    pub fn steel_modulus(self) -> f64 {
        match self {
            Units::InKipKsi => 29500.0,
            Units::MmNMpa => 29500.0 * 6.894757293168361,
            Units::MNPa => 29500.0 * 6.894757293168361e6,
        }
    }
}
