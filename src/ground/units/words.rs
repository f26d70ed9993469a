//! What messages say of a dimension: its name, and units that fit.

use std::fmt;

use super::dimension::Dimension;
use super::system::UnitSystem;

impl Dimension {
    /// The name with its article, for messages: "a length".
    pub fn name(self) -> String {
        let known = match self {
            Self::RATIO => "a number without a unit",
            Self::LENGTH => "a length",
            Self::AREA => "an area",
            Self::VOLUME => "a volume",
            Self::FORCE => "a force",
            Self::MOMENT => "a moment",
            Self::STRESS => "a stress",
            Self::LINE_LOAD => "a force per length",
            Self::CONTACT_STIFFNESS => "a stress per length",
            Self::ANGLE => "an angle",
            Self::TEMPERATURE => "a difference of temperature",
            Self::TEMPERATURE_GRADIENT => "a difference of temperature per length",
            Self::EXPANSION => "a coefficient of thermal expansion",
            _ => return format!("a quantity in {}", UnitSystem::MNPa.unit(self)),
        };
        known.to_string()
    }

    /// Units that fit, for messages.
    pub fn examples(self) -> String {
        match self {
            Self::RATIO => "none, or %".to_string(),
            Self::LENGTH => "in, ft, mil, m, cm, mm, µm".to_string(),
            Self::FORCE => "lbf, kip, N, kN, MN, kgf".to_string(),
            Self::STRESS => "psi, ksi, Pa, kPa, MPa, GPa, N/mm^2".to_string(),
            Self::LINE_LOAD => "lbf/in, kip/in, N/mm, kN/m".to_string(),
            Self::ANGLE => "deg, °, rad, mrad".to_string(),
            Self::TEMPERATURE => "K, degC, degF".to_string(),
            Self::EXPANSION => "1/K, 1/degF".to_string(),
            _ => {
                let units: Vec<String> = UnitSystem::ALL.iter().map(|s| s.unit(self)).collect();
                units.join(", ")
            }
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name())
    }
}
