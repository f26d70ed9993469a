//! Mesh presets as arguments.

use crate::case::bearing::Preset;
use clap::builder::{PossibleValue, PossibleValuesParser};

/// Takes the name of a preset, and lists them where help is asked for.
pub fn parser() -> PossibleValuesParser {
    PossibleValuesParser::new(Preset::ALL.map(|preset| {
        let help = match preset {
            Preset::Auto => "three elements or more across every half-width of contact",
            Preset::H025 => "0.025 in across the lines of contact of a roller of 3 in",
            Preset::H0125 => "half of that",
            Preset::ReportLike => "the uniform coarse mesh of the reference study, to compare with",
        };
        PossibleValue::new(preset.name()).help(help)
    }))
}
