//! What a quantity measures, as powers of force, length and angle.

use std::fmt;

use super::UnitSystem;

/// Powers of force, length and angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    pub(super) force: i32,
    pub(super) length: i32,
    pub(super) angle: i32,
}

impl Dimension {
    /// A strain, a coefficient of friction, Poisson's ratio, a share.
    pub const RATIO: Self = Self::new(0, 0, 0);
    pub const LENGTH: Self = Self::new(0, 1, 0);
    pub const AREA: Self = Self::new(0, 2, 0);
    pub const VOLUME: Self = Self::new(0, 3, 0);
    pub const FORCE: Self = Self::new(1, 0, 0);
    /// Force times length: a moment, or an energy.
    pub const MOMENT: Self = Self::new(1, 1, 0);
    /// Force per area.
    pub const STRESS: Self = Self::new(1, -2, 0);
    /// Force per length of a contact line.
    pub const LINE_LOAD: Self = Self::new(1, -1, 0);
    /// Force per displacement; the same powers as a line load.
    pub const STIFFNESS: Self = Self::LINE_LOAD;
    /// Pressure per penetration.
    pub const CONTACT_STIFFNESS: Self = Self::new(1, -3, 0);
    /// Radians inside the program, degrees outside.
    pub const ANGLE: Self = Self::new(0, 0, 1);

    pub(super) const fn new(force: i32, length: i32, angle: i32) -> Self {
        Self {
            force,
            length,
            angle,
        }
    }

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
