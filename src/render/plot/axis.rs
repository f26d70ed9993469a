//! Ranges of axes and the words at their ticks.

use super::data::{Panel, Scale};
use std::ops::Range;

/// What the axes of a panel reach over, along and upwards.
pub fn ranges(panel: &Panel) -> [Range<f64>; 2] {
    let points = || panel.lines.iter().flat_map(|line| &line.points);
    let (along, up) = (points().map(|p| p.0), points().map(|p| p.1));
    match panel.scale {
        Scale::Decades => [decades(along), decades(up)],
        Scale::DecadesUp => [between(along), decades(up)],
        Scale::Linear => [
            between(along),
            from_zero(up.chain(panel.dashed.iter().copied())),
        ],
    }
}

/// Smallest and largest of the finite values.
fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values
        .filter(|v| v.is_finite())
        .fold(None, |extent, v| match extent {
            None => Some((v, v)),
            Some((low, high)) => Some((v.min(low), v.max(high))),
        })
}

/// The decades that hold all of the positive values.
fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let Some((low, high)) = extent(values.filter(|v| *v > 0.0)) else {
        return 0.1..10.0;
    };
    let [low, mut high] = [
        low.log10().floor() as i32,
        (high * 1.001).log10().ceil() as i32,
    ];
    if low == high {
        high += 1;
    }
    10f64.powi(low)..10f64.powi(high)
}

/// The range of the values.
pub fn between(values: impl Iterator<Item = f64>) -> Range<f64> {
    match extent(values) {
        Some((low, high)) if low < high => low..high,
        Some((at, _)) if at != 0.0 => at - 0.5 * at.abs()..at + 0.5 * at.abs(),
        _ => -1.0..1.0,
    }
}

/// Room above the largest value, as a share of the range.
const ABOVE: f64 = 0.08;

/// From zero, or below where values are, to a little above the largest.
fn from_zero(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = extent(values).unwrap_or((0.0, 0.0));
    let (low, high) = (low.min(0.0), high.max(0.0));
    if high > low {
        low..high + ABOVE * (high - low)
    } else {
        0.0..1.0
    }
}

/// A power of ten.
pub fn power(value: &f64) -> String {
    match value.log10().round() as i32 {
        power @ -4..=4 => format!("{:.*}", (-power).max(0) as usize, value),
        power => format!("1e{power}"),
    }
}

/// A number on an axis over `range`: four significant digits, and zero where it is noise.
pub fn plain(value: f64, range: &Range<f64>) -> String {
    if value.abs() < 1e-9 * (range.end - range.start) {
        return "0".to_string();
    }
    let scientific = format!("{value:.3e}");
    match scientific.parse::<f64>() {
        Ok(rounded) if (1e-3..1e5).contains(&rounded.abs()) => rounded.to_string(),
        Ok(rounded) => format!("{rounded:e}"),
        Err(_) => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_whole_decades() {
        assert_eq!(decades([0.03, 5.0].into_iter()), 0.01..10.0);
        assert_eq!(decades([1.0].into_iter()), 1.0..10.0);
        assert_eq!(decades(std::iter::empty()), 0.1..10.0);
        assert_eq!(
            [power(&0.01), power(&100.0), power(&1e6)],
            ["0.01", "100", "1e6"]
        );
    }

    #[test]
    fn linear_ranges_hold_their_values_and_are_never_empty() {
        let nothing = || [f64::NAN].into_iter();
        assert_eq!(between([-4.0, 4.0].into_iter()), -4.0..4.0);
        assert_eq!(between([2.0].into_iter()), 1.0..3.0);
        assert_eq!(between(nothing()), -1.0..1.0);
        assert_eq!(from_zero([25.0, 0.0].into_iter()), 0.0..27.0);
        assert_eq!(from_zero(nothing()), 0.0..1.0);
        let range = 0.0..1.0;
        assert_eq!(plain(0.1 + 0.2, &range), "0.3");
        assert_eq!(plain(-1e-17, &range), "0");
        assert_eq!(plain(1.5e6, &range), "1.5e6");
    }
}
