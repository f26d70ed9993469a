//! The consistent systems of units a case may be written in.

use std::fmt;

use super::dimension::Dimension;
use super::symbol::{Base, Term, dimension, expression, symbol};

/// A length and a force; the stress follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnitSystem {
    InKipKsi,
    InLbfPsi,
    MmNMPa,
    MmKnGPa,
    MNPa,
}

impl UnitSystem {
    pub const ALL: [Self; 5] = [
        Self::InKipKsi,
        Self::InLbfPsi,
        Self::MmNMPa,
        Self::MmKnGPa,
        Self::MNPa,
    ];

    /// The name in a case file, length-force-stress.
    pub fn name(self) -> &'static str {
        match self {
            Self::InKipKsi => "in-kip-ksi",
            Self::InLbfPsi => "in-lbf-psi",
            Self::MmNMPa => "mm-N-MPa",
            Self::MmKnGPa => "mm-kN-GPa",
            Self::MNPa => "m-N-Pa",
        }
    }

    /// The system called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|system| system.name() == name)
    }

    pub fn length(self) -> &'static str {
        match self {
            Self::InKipKsi | Self::InLbfPsi => "in",
            Self::MmNMPa | Self::MmKnGPa => "mm",
            Self::MNPa => "m",
        }
    }

    pub fn force(self) -> &'static str {
        match self {
            Self::InKipKsi => "kip",
            Self::InLbfPsi => "lbf",
            Self::MmNMPa | Self::MNPa => "N",
            Self::MmKnGPa => "kN",
        }
    }

    pub fn stress(self) -> &'static str {
        match self {
            Self::InKipKsi => "ksi",
            Self::InLbfPsi => "psi",
            Self::MmNMPa => "MPa",
            Self::MmKnGPa => "GPa",
            Self::MNPa => "Pa",
        }
    }

    /// The unit of `dimension` in this system, as it is written; empty for a ratio. The unit of
    /// an angle is the degree, although the number inside the program is in radians.
    pub fn unit(self, dimension: Dimension) -> String {
        if dimension == Dimension::STRESS {
            return self.stress().to_string();
        }
        let bases = [
            (self.force(), dimension.force),
            (self.length(), dimension.length),
            ("deg", dimension.angle),
            ("K", dimension.temperature),
        ];
        let mut above: Vec<String> = Vec::new();
        let mut below = String::new();
        for (unit, power) in bases {
            let raised = match power.abs() {
                1 => unit.to_string(),
                n => format!("{unit}^{n}"),
            };
            if power > 0 {
                above.push(raised);
            } else if power < 0 && dimension.force > 0 {
                below.push('/');
                below.push_str(&raised);
            } else if power < 0 {
                above.push(format!("{unit}^{power}"));
            }
        }
        above.join("*") + &below
    }

    /// `value` (of this system) in the unit that [`UnitSystem::unit`] names: angles in degrees.
    pub fn shown(self, value: f64, dimension: Dimension) -> f64 {
        match dimension {
            Dimension::ANGLE => value.to_degrees(),
            _ => value,
        }
    }

    /// `value` (of this system) as text that reads back to the same number, with its unit.
    pub fn write(self, value: f64, dimension: Dimension) -> String {
        let shown = self.shown(value, dimension);
        format!("{shown} {}", self.unit(dimension))
            .trim_end()
            .to_string()
    }

    /// `value` (of this system) for people: six significant digits, with its unit.
    pub fn show(self, value: f64, dimension: Dimension) -> String {
        let shown = self.shown(value, dimension);
        // A detour over text rounds to decimal digits and drops trailing zeros.
        let rounded = format!("{shown:.5e}").parse::<f64>().unwrap_or(shown);
        let size = rounded.abs();
        let number = if size != 0.0 && !(1e-4..1e9).contains(&size) {
            format!("{rounded:e}")
        } else {
            format!("{rounded}")
        };
        format!("{number} {}", self.unit(dimension))
            .trim_end()
            .to_string()
    }

    /// The factor that takes a number of this system to `other`; one for angles and ratios.
    pub fn factor_to(self, other: Self, dimension: Dimension) -> f64 {
        let terms = [
            Term {
                base: Base::Force,
                size: self.size(Base::Force),
                power: dimension.force,
            },
            Term {
                base: Base::Length,
                size: self.size(Base::Length),
                power: dimension.length,
            },
        ];
        other.factor_from(&terms)
    }

    /// The factor that takes a number in the unit `terms` to this system.
    pub(super) fn factor_from(self, terms: &[Term]) -> f64 {
        let factor = |t: &Term| {
            if t.power >= 0 {
                (t.size / self.size(t.base)).powi(t.power)
            } else {
                (self.size(t.base) / t.size).powi(-t.power)
            }
        };
        terms.iter().map(factor).product()
    }

    /// The factor that takes a length in `unit` (a symbol such as `mm`) to this system; `None`
    /// where it is not a length.
    pub fn length_factor(self, unit: &str) -> Option<f64> {
        let terms = expression(unit).ok()?;
        let factor = self.factor_from(&terms);
        (dimension(&terms) == Dimension::LENGTH && factor.is_finite()).then_some(factor)
    }

    fn size(self, base: Base) -> f64 {
        let own = match base {
            Base::Force => self.force(),
            Base::Length => self.length(),
            Base::Angle | Base::Temperature | Base::Ratio => return 1.0,
        };
        symbol(own)
            .and_then(|terms| terms.first().map(|t| t.size))
            .unwrap_or(1.0)
    }
}

impl fmt::Display for UnitSystem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
