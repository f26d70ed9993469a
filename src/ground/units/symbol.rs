//! Unit symbols and expressions of them, such as `kip/in^2`.

use super::dimension::Dimension;

/// What a base unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Base {
    Force,
    Length,
    Angle,
    Temperature,
    Ratio,
}

/// A base unit to a power.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Term {
    pub base: Base,
    /// In 1e-13 N, nm, radians, kelvins or ones. Forces and lengths are whole numbers that `f64` holds
    /// exactly, so the ratio of two of them is the nearest `f64` to the true factor.
    pub size: f64,
    pub power: i32,
}

// Lengths in nm.
const M: f64 = 1e9;
const MM: f64 = 1e6;
const INCH: f64 = 25_400_000.0;
// Forces in 1e-13 N.
const N: f64 = 1e13;
const KN: f64 = 1e16;
const LBF: f64 = 44_482_216_152_605.0;
const KIP: f64 = 44_482_216_152_605_000.0;
const KGF: f64 = 98_066_500_000_000.0;

fn one(base: Base, size: f64) -> Vec<Term> {
    vec![Term {
        base,
        size,
        power: 1,
    }]
}

fn per_area(force: f64, length: f64) -> Vec<Term> {
    vec![
        Term {
            base: Base::Force,
            size: force,
            power: 1,
        },
        Term {
            base: Base::Length,
            size: length,
            power: -2,
        },
    ]
}

/// The terms of one symbol, `None` where it is not known.
pub(super) fn symbol(name: &str) -> Option<Vec<Term>> {
    Some(match name {
        "km" => one(Base::Length, 1e3 * M),
        "m" => one(Base::Length, M),
        "cm" => one(Base::Length, 1e7),
        "mm" => one(Base::Length, MM),
        // The micro sign, the Greek letter mu, and the makeshift.
        "\u{b5}m" | "\u{3bc}m" | "um" => one(Base::Length, 1e3),
        "nm" => one(Base::Length, 1.0),
        "in" | "inch" => one(Base::Length, INCH),
        "ft" => one(Base::Length, 12.0 * INCH),
        "mil" => one(Base::Length, 25_400.0),
        "N" => one(Base::Force, N),
        "kN" => one(Base::Force, KN),
        "MN" => one(Base::Force, 1e19),
        "lbf" => one(Base::Force, LBF),
        "kip" | "kips" => one(Base::Force, KIP),
        "kgf" => one(Base::Force, KGF),
        "Pa" => per_area(N, M),
        "kPa" => per_area(KN, M),
        "MPa" => per_area(N, MM),
        "GPa" => per_area(KN, MM),
        "psi" => per_area(LBF, INCH),
        "ksi" => per_area(KIP, INCH),
        "rad" => one(Base::Angle, 1.0),
        "mrad" => one(Base::Angle, 1e-3),
        "deg" | "°" => one(Base::Angle, std::f64::consts::PI / 180.0),
        // Differences.
        "K" | "degC" | "°C" => one(Base::Temperature, 1.0),
        "degF" | "°F" => one(Base::Temperature, 5.0 / 9.0),
        "%" => one(Base::Ratio, 0.01),
        _ => return None,
    })
}

/// Every symbol, for "did you mean".
pub(super) const SYMBOLS: [&str; 30] = [
    "km", "m", "cm", "mm", "µm", "um", "nm", "in", "inch", "ft", "mil", "N", "kN", "MN", "lbf",
    "kip", "kgf", "Pa", "kPa", "MPa", "GPa", "psi", "ksi", "rad", "mrad", "deg", "K", "degC",
    "degF", "%",
];

const OPERATORS: [char; 4] = ['/', '*', '·', '⋅'];

/// The terms of an expression such as `kip/in^2`, `N/mm²`, `kN·m` or `kN m`; on failure the symbol that
/// is not known.
pub(super) fn expression(text: &str) -> Result<Vec<Term>, String> {
    let mut terms = Vec::new();
    let mut sign = 1;
    let mut rest = text.trim();
    loop {
        let is_sign = |c: char| OPERATORS.contains(&c);
        let ends = |c: char| is_sign(c) || c.is_whitespace();
        let end = rest.find(ends).unwrap_or(rest.len());
        let (factor, after) = (&rest[..end], rest[end..].trim_start());
        // As in 1/K.
        let is_one = factor == "1" && terms.is_empty();
        let (name, power) = split_power(factor).ok_or_else(|| factor.to_string())?;
        let found = match symbol(name) {
            Some(found) => found,
            None if is_one => Vec::new(),
            None => return Err(name.to_string()),
        };
        terms.extend(found.into_iter().map(|t| Term {
            power: t.power * power * sign,
            ..t
        }));
        if after.is_empty() {
            return Ok(terms);
        }
        sign = if after.starts_with('/') { -1 } else { 1 };
        rest = after.strip_prefix(is_sign).unwrap_or(after).trim_start();
    }
}

/// `in^2`, `in2` and `in²` into `in` and 2. Powers beyond 4 are taken for garbage.
fn split_power(factor: &str) -> Option<(&str, i32)> {
    let is_digit = |c: char| c.is_ascii_digit() || "²³⁴".contains(c);
    let name = factor.trim_end_matches(is_digit);
    let power = match &factor[name.len()..] {
        "" if factor.contains('^') => return None,
        "" | "1" => 1,
        "2" | "²" => 2,
        "3" | "³" => 3,
        "4" | "⁴" => 4,
        _ => return None,
    };
    if let Some(base) = name.strip_suffix("^-") {
        return Some((base, -power));
    }
    Some((name.strip_suffix('^').unwrap_or(name), power))
}

/// The dimension of an expression.
pub(super) fn dimension(terms: &[Term]) -> Dimension {
    let sum = |base| {
        terms
            .iter()
            .filter(|t| t.base == base)
            .map(|t| t.power)
            .sum()
    };
    Dimension::new(sum(Base::Force), sum(Base::Length), sum(Base::Angle))
        .per_kelvin(-sum(Base::Temperature))
}
