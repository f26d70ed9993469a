//! A number with a unit, read from text.

use super::dimension::Dimension;
use super::symbol::{SYMBOLS, Term, dimension, expression};
use super::system::UnitSystem;

/// A finite number and its unit, as they were written.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    value: f64,
    terms: Vec<Term>,
    text: String,
}

/// Why a text is not the quantity that is wanted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    #[error("`{text}` does not begin with a number")]
    NoNumber { text: String },
    #[error("`{text}` is not finite")]
    NotFinite { text: String },
    #[error("`{text}`: the unit `{unit}` is not known{}", did_you_mean(.suggestion.as_deref()))]
    UnknownUnit {
        text: String,
        unit: String,
        suggestion: Option<&'static str>,
    },
    #[error("`{text}` has no unit; {wanted} is wanted: {}", .wanted.examples())]
    NoUnit { text: String, wanted: Dimension },
    #[error("`{text}` is {found}; {wanted} is wanted: {}", .wanted.examples())]
    WrongDimension {
        text: String,
        found: Dimension,
        wanted: Dimension,
    },
}

fn did_you_mean(word: Option<&str>) -> String {
    word.map_or_else(String::new, |w| format!("; did you mean `{w}`?"))
}

impl std::fmt::Display for Quantity {
    /// As it was written.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}

impl Quantity {
    /// Reads `65 kip`, `3in`, `-1.5e-3 mm`, `8.125 kip/in`, `200 N/mm²`, `4 deg`, `10 µm`, `0.15`.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        let text = text.trim();
        let end = number_end(text);
        let unit = text[end..].trim();
        let word = text
            .trim_start_matches(['+', '-', '−'])
            .to_ascii_lowercase();
        if word.starts_with("inf") || word.starts_with("nan") {
            return Err(UnitError::NotFinite {
                text: text.to_string(),
            });
        }
        // People paste the true minus sign.
        let value: f64 =
            text[..end]
                .replace('−', "-")
                .parse()
                .map_err(|_| UnitError::NoNumber {
                    text: text.to_string(),
                })?;
        if !value.is_finite() {
            return Err(UnitError::NotFinite {
                text: text.to_string(),
            });
        }
        let terms = match unit {
            "" => Vec::new(),
            _ => expression(unit).map_err(|unit| {
                let suggestion = nearest_symbol(&unit);
                UnitError::UnknownUnit {
                    text: text.to_string(),
                    unit,
                    suggestion,
                }
            })?,
        };
        Ok(Self {
            value,
            terms,
            text: text.to_string(),
        })
    }

    /// What it measures.
    pub fn dimension(&self) -> Dimension {
        dimension(&self.terms)
    }

    /// The number in `system`, angles in radians; an error where it does not measure `wanted`.
    pub fn value_in(&self, system: UnitSystem, wanted: Dimension) -> Result<f64, UnitError> {
        let found = self.dimension();
        let text = || self.text.clone();
        if self.terms.is_empty() && wanted != Dimension::RATIO {
            return Err(UnitError::NoUnit {
                text: text(),
                wanted,
            });
        }
        if found != wanted {
            return Err(UnitError::WrongDimension {
                text: text(),
                found,
                wanted,
            });
        }
        let value = self.value * system.factor_from(&self.terms);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(UnitError::NotFinite { text: text() })
        }
    }
}

/// The length in bytes of the number at the start of `text`.
fn number_end(text: &str) -> usize {
    let sign = text
        .chars()
        .next()
        .filter(|c| "+-−".contains(*c))
        .map_or(0, char::len_utf8);
    let digits = |from: usize| {
        let rest = &text[from..];
        from + rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len()
    };
    let mut end = digits(sign);
    if text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    // An exponent only where digits follow: the `e` may begin a unit.
    if text[end..].starts_with(['e', 'E']) {
        let after = end + 1;
        let sign = text[after..].chars().next().filter(|c| "+-−".contains(*c));
        let start = after + sign.map_or(0, char::len_utf8);
        if digits(start) > start {
            end = digits(start);
        }
    }
    end
}

/// A symbol that differs from `unit` in case only, or that people mean by it.
fn nearest_symbol(unit: &str) -> Option<&'static str> {
    let meant = match unit {
        "lb" | "lbs" => "lbf",
        "inches" | "\"" => "in",
        "feet" | "foot" | "'" => "ft",
        "degree" | "degrees" => "deg",
        "klb" | "kipf" | "kilopound" => "kip",
        "micron" => "µm",
        _ => return SYMBOLS.into_iter().find(|s| s.eq_ignore_ascii_case(unit)),
    };
    Some(meant)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, system: UnitSystem, dimension: Dimension) -> f64 {
        Quantity::parse(text)
            .unwrap()
            .value_in(system, dimension)
            .unwrap()
    }

    #[test]
    fn a_unit_of_the_system_leaves_the_number_alone() {
        use UnitSystem::*;
        assert_eq!(value("0.1 in", InKipKsi, Dimension::LENGTH), 0.1);
        assert_eq!(value("29500.3 ksi", InKipKsi, Dimension::STRESS), 29500.3);
        assert_eq!(value("0.3 kip/in^2", InKipKsi, Dimension::STRESS), 0.3);
        assert_eq!(value("210.7 GPa", MmKnGPa, Dimension::STRESS), 210.7);
        assert_eq!(value("0.7 N/mm²", MmNMPa, Dimension::STRESS), 0.7);
    }

    #[test]
    fn factors_are_the_exact_definitions() {
        use UnitSystem::*;
        assert_eq!(value("1 in", MmNMPa, Dimension::LENGTH), 25.4);
        assert_eq!(value("1 in", MNPa, Dimension::LENGTH), 0.0254);
        assert_eq!(value("1 ft", InKipKsi, Dimension::LENGTH), 12.0);
        assert_eq!(value("1 mil", InKipKsi, Dimension::LENGTH), 0.001);
        assert_eq!(value("1 lbf", MNPa, Dimension::FORCE), 4.4482216152605);
        assert_eq!(value("1 kip", MmNMPa, Dimension::FORCE), 4448.2216152605);
        assert_eq!(value("1 kgf", MmNMPa, Dimension::FORCE), 9.80665);
        let ksi = value("1 ksi", MmNMPa, Dimension::STRESS);
        assert!((ksi / 6.894_757_293_168_361 - 1.0).abs() < 4e-16);
        let line = value("1 kip/in", MmNMPa, Dimension::LINE_LOAD);
        assert!((line / 175.126_835_246_476_4 - 1.0).abs() < 4e-16);
        assert_eq!(
            value("180 deg", MNPa, Dimension::ANGLE),
            std::f64::consts::PI
        );
        assert_eq!(value("15 %", MNPa, Dimension::RATIO), 0.15);
    }

    #[test]
    fn notations() {
        use UnitSystem::MmNMPa;
        for text in [
            "10 µm",
            "10 μm",
            "10um",
            "+1.0e-2mm",
            "1E-2 mm",
            " .01 mm ",
            "1.e-2 mm",
        ] {
            assert!(
                (value(text, MmNMPa, Dimension::LENGTH) - 0.01).abs() < 1e-17,
                "{text}"
            );
        }
        assert_eq!(value("−3 mm", MmNMPa, Dimension::LENGTH), -3.0);
        for text in [
            "2 N/mm^2",
            "2 N/mm2",
            "2 N*mm^-2",
            "2N/mm/mm",
            "2 N·mm^-2",
            "2 N mm^-2",
            "2 N / mm / mm",
            "2 MPa",
        ] {
            assert_eq!(value(text, MmNMPa, Dimension::STRESS), 2.0, "{text}");
        }
    }

    #[test]
    fn refusals_say_why() {
        let wrong = |text: &str, dimension| {
            let quantity = Quantity::parse(text);
            let result = quantity.and_then(|q| q.value_in(UnitSystem::InKipKsi, dimension));
            result.unwrap_err().to_string()
        };
        assert_eq!(
            wrong("3 ksi", Dimension::LENGTH),
            "`3 ksi` is a stress; a length is wanted: in, ft, mil, m, cm, mm, µm"
        );
        let area = wrong("3 in in", Dimension::LENGTH);
        assert!(area.contains("is an area; a length is wanted"), "{area}");
        assert!(wrong("3", Dimension::LENGTH).contains("has no unit; a length is wanted"));
        assert!(wrong("3 mpa", Dimension::STRESS).ends_with("did you mean `MPa`?"));
        assert!(wrong("3 furlong", Dimension::LENGTH).contains("`furlong` is not known"));
        assert!(wrong("three in", Dimension::LENGTH).contains("does not begin with a number"));
        assert!(wrong("", Dimension::RATIO).contains("does not begin with a number"));
        for text in ["inf in", "-nan", "NaN in", "1e999 in"] {
            assert!(
                wrong(text, Dimension::LENGTH).contains("not finite"),
                "{text}"
            );
        }
        for text in [
            "3 in^", "3 in^9", "3 /in", "3 in/", "3 ^2", "0,75 in", "1.2.3 in",
        ] {
            assert!(
                wrong(text, Dimension::LENGTH).contains("not known"),
                "{text}"
            );
        }
    }

    #[test]
    fn numbers_are_dressed_again() {
        use UnitSystem::*;
        assert_eq!(InKipKsi.show(65.0, Dimension::FORCE), "65 kip");
        assert_eq!(
            InKipKsi.show(8.125_000_01, Dimension::LINE_LOAD),
            "8.125 kip/in"
        );
        assert_eq!(
            MNPa.show(2.033_953_4e11, Dimension::STRESS),
            "2.03395e11 Pa"
        );
        assert_eq!(MmNMPa.show(4f64.to_radians(), Dimension::ANGLE), "4 deg");
        assert_eq!(MmNMPa.show(0.0, Dimension::LENGTH), "0 mm");
        assert_eq!(MmNMPa.show(0.15, Dimension::RATIO), "0.15");
        assert_eq!(MmNMPa.unit(Dimension::MOMENT), "N*mm");
        assert_eq!(MmNMPa.unit(Dimension::CONTACT_STIFFNESS), "N/mm^3");
        assert_eq!(MmNMPa.unit(Dimension::AREA), "mm^2");
        assert_eq!(MmNMPa.length_factor("in"), Some(25.4));
        assert_eq!(MmNMPa.length_factor("kip"), None);
    }
}
