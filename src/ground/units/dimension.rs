//! What a quantity measures, as powers of force, length, angle and temperature.

/// Powers of force, length, angle and temperature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    pub(super) force: i32,
    pub(super) length: i32,
    pub(super) angle: i32,
    pub(super) temperature: i32,
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
    /// Pressure per penetration.
    pub const CONTACT_STIFFNESS: Self = Self::new(1, -3, 0);
    /// Radians inside the program, degrees outside.
    pub const ANGLE: Self = Self::new(0, 0, 1);

    /// A difference of temperature, in kelvin in every system.
    pub const TEMPERATURE: Self = Self::RATIO.per_kelvin(-1);
    /// A difference of temperature per length.
    pub const TEMPERATURE_GRADIENT: Self = Self::new(0, -1, 0).per_kelvin(-1);
    /// A coefficient of thermal expansion.
    pub const EXPANSION: Self = Self::RATIO.per_kelvin(1);

    /// Divided by a temperature to the `power`.
    pub(super) const fn per_kelvin(self, power: i32) -> Self {
        Self {
            temperature: self.temperature - power,
            ..self
        }
    }

    pub(super) const fn new(force: i32, length: i32, angle: i32) -> Self {
        Self {
            force,
            length,
            angle,
            temperature: 0,
        }
    }
}
