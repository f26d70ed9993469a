//! The axes of a drawing on the page: ticks at round numbers, and where a value comes to stand.

use maud::{Markup, html};
use std::ops::Range;

/// One axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What it shows, with its unit.
    pub label: String,
    pub range: Range<f64>,
    /// Are equal distances equal ratios?
    pub logarithmic: bool,
}

/// Where a drawing stands in its picture, in the units of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewport {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Axis {
    /// A linear axis over `range`, or about it where it is empty.
    pub fn linear(label: impl Into<String>, range: Range<f64>) -> Self {
        let pad = match range.end - range.start {
            width if width > 0.0 => 0.0,
            _ => 0.5 * range.start.abs().max(1e-9),
        };
        Self {
            label: label.into(),
            range: range.start - pad..range.end + pad,
            logarithmic: false,
        }
    }

    /// A logarithmic axis over whole decades.
    pub fn decades(label: impl Into<String>, range: Range<f64>) -> Self {
        Self {
            label: label.into(),
            range,
            logarithmic: true,
        }
    }

    /// Where `value` stands: 0 at the start of the axis, 1 at its end.
    pub fn share(&self, value: f64) -> f64 {
        let of = |v: f64| if self.logarithmic { v.log10() } else { v };
        let (start, end) = (of(self.range.start), of(self.range.end));
        (of(value) - start) / (end - start)
    }

    /// Round numbers on the axis and their names, about `count` of them.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.logarithmic {
            let (low, high) = (self.range.start.log10(), self.range.end.log10());
            let (low, high) = (low.round() as i32, high.round() as i32);
            let every = (high - low) / count.max(1) as i32 + 1;
            let powers = (low..=high).filter(|p| (p - low) % every == 0);
            return powers.map(|p| (10f64.powi(p), power_of_ten(p))).collect();
        }
        // Two ticks at least, for what is one number worth?
        let mut finer = (count.max(1)..4 * count.max(1) + 4).map(|c| self.linear_ticks(c));
        let enough = |ticks: &Vec<_>| ticks.len() > 1;
        finer.find(enough).unwrap_or_default()
    }

    fn linear_ticks(&self, count: usize) -> Vec<(f64, String)> {
        let step = round_step((self.range.end - self.range.start) / count as f64);
        let slack = 1e-9 * (self.range.end - self.range.start);
        let first = ((self.range.start - slack) / step).ceil() as i64;
        let last = ((self.range.end + slack) / step).floor() as i64;
        let decimals = (-step.log10().floor()).max(0.0) as usize;
        let name = |value: f64| match step {
            step if !(1e-5..1e6).contains(&step) && value != 0.0 => format!("{value:.1e}"),
            _ => format!("{:.decimals$}", if value == 0.0 { 0.0 } else { value }),
        };
        (first..=last.min(first + 40))
            .map(|k| (k as f64 * step, name(k as f64 * step)))
            .collect()
    }
}

/// 1, 2 or 5 times a power of ten, no less than `least`.
fn round_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|s| s * power);
    steps
        .into_iter()
        .find(|s| *s >= least * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

fn power_of_ten(power: i32) -> String {
    let digits: String = power
        .to_string()
        .chars()
        .map(|c| match c.to_digit(10) {
            Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
            None => '⁻',
        })
        .collect();
    format!("10{digits}")
}

/// Least distance between ticks, in units of the picture.
const TICK_DISTANCE_ALONG: f64 = 75.0;
const TICK_DISTANCE_UP: f64 = 45.0;

impl Viewport {
    /// Where the values stand in the picture.
    pub fn at(&self, [x, y]: [&Axis; 2], (u, v): (f64, f64)) -> [f64; 2] {
        [
            self.left + x.share(u) * self.width,
            self.top + (1.0 - y.share(v)) * self.height,
        ]
    }

    /// Frame, ticks and labels; `grid` draws lines across.
    pub fn frame(&self, axes: [&Axis; 2], grid: bool) -> Markup {
        let Self {
            left,
            top,
            width,
            height,
        } = *self;
        let bottom = top + height;
        let [x, y] = axes;
        let at = |values| self.at(axes, values);
        html! {
            g class="axes" {
                @for (value, name) in x.ticks((width / TICK_DISTANCE_ALONG) as usize) {
                    @let [u, _] = at((value, y.range.start));
                    @if grid { path class="grid" d=(format!("M{u:.1} {top}V{bottom}")) {} }
                    path d=(format!("M{u:.1} {bottom}v4")) {}
                    text x=(format!("{u:.1}")) y=(bottom + 17.0) text-anchor="middle" { (name) }
                }
                @for (value, name) in y.ticks((height / TICK_DISTANCE_UP).max(2.0) as usize) {
                    @let [_, v] = at((x.range.start, value));
                    @if grid { path class="grid" d=(format!("M{left} {v:.1}h{width}")) {} }
                    path d=(format!("M{left} {v:.1}h-4")) {}
                    text x=(left - 8.0) y=(format!("{:.1}", v + 4.0)) text-anchor="end" { (name) }
                }
                rect x=(left) y=(top) width=(width) height=(height) {}
                text x=(left + 0.5 * width) y=(bottom + 35.0) text-anchor="middle" { (x.label) }
                text transform=(format!("translate({} {}) rotate(-90)", left - 50.0, top + 0.5 * height))
                    text-anchor="middle" { (y.label) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(range: Range<f64>, count: usize) -> Vec<String> {
        let ticks = Axis::linear("", range).ticks(count);
        ticks.into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn ticks_are_round_and_within_the_range() {
        assert_eq!(names(0.0..1.0, 4), ["0.0", "0.5", "1.0"]);
        assert_eq!(names(-0.031..0.031, 2), ["-0.02", "0.00", "0.02"]);
        assert_eq!(names(-0.031..0.031, 4), ["-0.02", "0.00", "0.02"]);
        assert_eq!(names(0.0..180.0, 4), ["0", "50", "100", "150"]);
        assert!(!names(3.0..3.0, 4).is_empty());
    }

    #[test]
    fn decades_have_powers() {
        let axis = Axis::decades("", 1e-9..10.0);
        let ticks = axis.ticks(5);
        assert_eq!(ticks.first().map(|t| t.1.as_str()), Some("10⁻⁹"));
        assert!((axis.share(1e-4) - 0.5).abs() < 1e-12);
    }
}
