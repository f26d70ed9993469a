//! Numbers, places and lists in plain text.

use crate::ground::units::Quantity;
use std::borrow::Cow;

/// `value` with `digits` significant digits, trailing zeros kept; a dash for what is no number.
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "-".to_string();
    }
    if value == 0.0 {
        return "0".to_string();
    }
    let digits = digits.max(1);
    // Rounding may lift the exponent, as of 9.996 to 10.00.
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, e)| e.parse::<i32>().ok())
        .unwrap_or(0);
    if exponent < -4 || exponent > digits.max(5) as i32 {
        return scientific;
    }
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    format!("{value:.decimals$}")
}

/// `value` as a percentage of three significant digits.
pub fn percent(value: f64) -> String {
    format!("{} %", significant(100.0 * value, 3))
}

/// A place in the case's coordinates: four decimals, or five digits of the largest where all are small, as in metres.
pub fn place(at: [f64; 3]) -> String {
    let largest = at.into_iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    let decimals = (4.0 - largest.log10().floor()).clamp(4.0, 15.0) as usize;
    let [x, y, z] = at.map(|v| {
        if v.abs() < 0.5 * 0.1f64.powi(decimals as i32) {
            "0".to_string()
        } else {
            format!("{v:.decimals$}")
        }
    });
    format!("({x}, {y}, {z})")
}

/// Sentences below a heading; nothing where there are none.
pub fn list<'a>(heading: &str, entries: impl IntoIterator<Item = &'a String>) -> String {
    let entries = entries.into_iter();
    let lines: String = entries.map(|entry| format!("  - {entry}\n")).collect();
    if lines.is_empty() {
        lines
    } else {
        format!("{heading}\n{lines}")
    }
}

/// `text` as a cell that a spreadsheet shows: an apostrophe stands before what it would calculate.
pub fn shown(text: &str) -> Cow<'_, str> {
    let is_number = || text.parse::<f64>().is_ok() || Quantity::parse(text).is_ok();
    let is_formula =
        text.starts_with(['=', '@', '\t', '\r']) || text.starts_with(['+', '-']) && !is_number();
    if is_formula {
        Cow::Owned(format!("'{text}"))
    } else {
        Cow::Borrowed(text)
    }
}

/// `text` as the value of an XML attribute.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// The text of an XML attribute value that [`escape`] made.
pub fn unescape(text: &str) -> String {
    text.replace("&quot;", "\"")
        .replace("&gt;", ">")
        .replace("&lt;", "<")
        .replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_significant_digits() {
        let of = |v| significant(v, 4);
        assert_eq!(of(104.25), "104.2");
        assert_eq!(of(-9.9996), "-10.00");
        assert_eq!(of(0.010_951), "0.01095");
        assert_eq!(of(29500.0), "29500");
        assert_eq!(of(1.234_56e-7), "1.235e-7");
        assert_eq!(of(1.5e9), "1.500e9");
        assert_eq!(of(f64::NAN), "-");
        assert_eq!(of(0.0), "0");
        assert_eq!(significant(123.4, 2), "123");
    }

    #[test]
    fn places_have_digits_in_any_unit() {
        assert_eq!(place([12.5, 3e-5, -0.25]), "(12.5000, 0, -0.2500)");
        let metres = place([0.00614, 1e-8, 0.0121]);
        assert_eq!(metres, "(0.006140, 0, 0.012100)");
        assert_eq!(place([0.0; 3]), "(0, 0, 0)");
    }

    #[test]
    fn formulas_are_shown_and_numbers_stay() {
        for text in ["=1+1", "@sum(a1)", "+cmd|' /c calc'!a0", "-2+3", "\t=1"] {
            assert_eq!(shown(text), format!("'{text}"));
        }
        for text in ["-0.5 in", "+3", "-1e-3", "upper-lower", "a=b", ""] {
            assert_eq!(shown(text), text);
        }
    }

    #[test]
    fn attribute_values_survive() {
        let nasty = "a<b> & \"c\" &lt;";
        assert!(!escape(nasty).contains('"'));
        assert_eq!(unescape(&escape(nasty)), nasty);
    }
}
