//! Figures as an engineer reads them: no more digits than they are worth.

use crate::render::text::significant;

/// Digits of a figure of which no error is known.
pub const DIGITS: usize = 4;
/// Digits of positions, lengths and strains.
pub const POSITION_DIGITS: usize = 3;
/// Digits of a figure that belongs to its mesh, and of an error.
pub const MESH_DIGITS: usize = 2;

/// In place of a figure that there is not, on a page.
pub const DASH: &str = "–";

/// A share as a percentage of three digits, or a dash.
pub fn share(value: Option<f64>) -> String {
    value.map_or_else(
        || DASH.to_string(),
        |v| format!("{} %", significant(100.0 * v, 3)),
    )
}

/// A figure and its error, both as far as the first digit of the error, or the second where the
/// first is 1; with four digits where nothing is known of it.
pub fn with_error(value: f64, error: Option<f64>) -> String {
    let Some(error) = error.filter(|e| e.is_finite() && *e > 0.0 && value.is_finite()) else {
        return significant(value, DIGITS);
    };
    let mut place = error.log10().floor();
    if error / 10f64.powf(place) < 2.0 {
        place -= 1.0;
    }
    // An error far below the figure asks for no more than five digits.
    let finest = value.abs().max(error).log10().floor() - 4.0;
    let place = place.max(finest) as i32;
    let unit = 10f64.powi(place);
    let decimals = usize::try_from(-place).unwrap_or(0);
    let [value, error] = [value, error].map(|v| (v / unit).round() + 0.0);
    // So many units, down to that place; no zero has a sign.
    let written = |units: f64| {
        let digits = units.abs().log10().max(0.0) as usize;
        match (-6..=5).contains(&place) {
            true => format!("{:.decimals$}", units * unit),
            false => format!("{:.digits$e}", units * unit),
        }
    };
    if error > 0.0 {
        format!("{} ± {}", written(value), written(error))
    } else {
        format!("{} ± < {}", written(value), written(1.0))
    }
}

/// How far off something is, relative to it. What rounding may make, and another machine may make
/// otherwise, is only said to be small.
pub fn off(share: f64) -> String {
    /// Far above rounding, and far below what any reader asks of an error.
    const SMALL: f64 = 1e-5;
    if share != 0.0 && share.abs() < SMALL {
        return format!("< {} %", 100.0 * SMALL);
    }
    format!("{} %", significant(100.0 * share, MESH_DIGITS))
}

/// In place of a figure of which nothing is known.
pub const NOT_RESOLVED: &str = "not resolved";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_decide_the_digits() {
        assert_eq!(with_error(95.81, Some(15.3)), "96 ± 15");
        assert_eq!(with_error(0.010_97, Some(0.000_78)), "0.0110 ± 0.0008");
        assert_eq!(with_error(238.2, None), "238.2");
        assert_eq!(with_error(238.2, Some(1e-9)), "238.20 ± < 0.01");
        assert_eq!(with_error(12_345.0, Some(700.0)), "12300 ± 700");
        assert_eq!(with_error(f64::NAN, Some(1.0)), "-");
        // Beyond the range of plain numbers, too.
        let descent = with_error(3.7456e-6, Some(3.1e-9));
        assert_eq!(descent, "3.746e-6 ± 3e-9");
        assert_eq!(with_error(1.875_43e9, Some(2e6)), "1.875e9 ± 2e6");
        assert_eq!(with_error(-2e-10, Some(1.3e-8)), "0e0 ± 1.3e-8");
    }

    #[test]
    fn rounding_has_no_digits() {
        assert_eq!(off(0.042), "4.2 %");
        assert_eq!(off(1.7e-5), "0.0017 %");
        assert_eq!(off(8.5e-7), "< 0.001 %");
        assert_eq!(off(0.0), "0 %");
    }
}
