//! Mesh presets by name.

use std::fmt;
use std::str::FromStr;

/// A named choice of element sizes.
///
/// Lengths below are for the reference bearing, D = 3 in, and scale with D: `h025` has 0.025 in
/// across the contact lines of a roller of 3 in and D/120 in general. At the working stresses of
/// bearing steel the contact strips scale with D too (half-width about 0.02 R at p0 = E*/100).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Preset {
    /// Sized from the half-widths of the lines of contact.
    #[default]
    Auto,
    /// 0.025 in across the contact lines.
    H025,
    /// 0.0125 in across the contact lines.
    H0125,
    /// The uniform coarse mesh of the reference study, for comparison only.
    ReportLike,
}

impl Preset {
    /// Those that a case may ask for, the default first.
    pub const ALL: [Self; 4] = [Self::Auto, Self::H025, Self::H0125, Self::ReportLike];

    /// As in case files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::H025 => "h025",
            Self::H0125 => "h0125",
            Self::ReportLike => "report-like",
        }
    }
}

impl fmt::Display for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Preset {
    type Err = UnknownPreset;

    fn from_str(name: &str) -> Result<Self, UnknownPreset> {
        let known = Self::ALL.into_iter().find(|preset| preset.name() == name);
        known.ok_or_else(|| UnknownPreset(name.into()))
    }
}

/// A preset that there is not.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, miette::Diagnostic)]
#[error(
    "`{0}` is not a mesh preset; it must be one of: {names}",
    names = Preset::ALL.map(|preset| preset.name()).join(", ")
)]
#[diagnostic(code(brinell::case::preset))]
pub struct UnknownPreset(pub String);

#[cfg(test)]
mod tests {
    use super::*;
    #[test]
    fn presets_go_by_their_names() {
        for preset in Preset::ALL {
            assert_eq!(preset.to_string().parse(), Ok(preset));
        }
        assert!("h05".parse::<Preset>().is_err());
        assert_eq!(Preset::default(), Preset::Auto);
    }
}
