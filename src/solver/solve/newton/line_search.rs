//! How far to follow a correction.
//!
//! For fixed multipliers the residual of an elastic, frictionless scene is the slope of a convex
//! energy, so the best step along dx is where the work of the residual on dx vanishes.

use crate::solver::solve::params::{LINE_SEARCH_SLOPE, LINE_SEARCH_TRIES};

/// Finds a step in (0, 1] where |slope| has fallen to `share` of its value at 0.
///
/// `slope(step)` is the work of the residual on the correction at that step; `start` is its value
/// at 0, positive for a descent direction. Returns the step whose evaluation was the last call.
pub fn search_line(start: f64, full: f64, mut slope: impl FnMut(f64) -> f64) -> f64 {
    // Only an overshoot is worth a search: the slope has changed its sign and grown.
    if !full.is_finite() || (full < 0.0 && full.abs() > LINE_SEARCH_SLOPE * start.abs()) {
        let (mut low, mut low_slope) = (0.0, start);
        let (mut high, mut high_slope) = (1.0, full);
        let mut step = 1.0;
        for _ in 0..LINE_SEARCH_TRIES {
            let secant = low + (high - low) * low_slope / (low_slope - high_slope);
            // Regula falsi, kept off the ends; bisection where a slope is not a number.
            let (least, most) = (low + 0.1 * (high - low), low + 0.9 * (high - low));
            step = if secant.is_finite() {
                secant.clamp(least, most)
            } else {
                0.5 * (low + high)
            };
            let value = slope(step);
            if value.is_finite() && value.abs() <= LINE_SEARCH_SLOPE * start.abs() {
                return step;
            }
            if value > 0.0 {
                (low, low_slope) = (step, value);
            } else {
                (high, high_slope) = (step, value);
            }
        }
        return step;
    }
    1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_step_that_undershoots_is_taken() {
        assert_eq!(search_line(1.0, 0.9, |_| unreachable!()), 1.0);
    }

    #[test]
    fn an_overshoot_is_bracketed() {
        // A contact spring far stiffer than predicted engages at step 0.2.
        let slope = |s: f64| 1.0 - s - if s > 0.2 { 100.0 * (s - 0.2) } else { 0.0 };
        let step = search_line(1.0, slope(1.0), slope);
        assert!(slope(step).abs() <= 0.5, "{step}");
    }
}
