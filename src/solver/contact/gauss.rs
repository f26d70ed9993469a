//! A rule on triangles for functions that are smooth, but no polynomials.
//!
//! Seen on a facet that is no parallelogram, shape functions of the facet opposite are quotients and roots. Their
//! integrals converge as powers of the number of points, the quicker the less the facets are distorted.

use super::clip::Point;
use crate::ground::geometry::range;
use std::sync::OnceLock;

/// Points along each side of the square that is folded to a triangle, at most.
const MOST_POINTS: usize = 16;

/// Error of an integral that counts as rounding.
const ROUNDING: f64 = 1e-14;

/// A point of a rule: barycentric coordinates and weight; the weights sum to one.
pub(super) type RulePoint = ([f64; 3], f64);

/// How far a quadrilateral is from a parallelogram: by how much its Jacobian varies about its mean, as a share. Where it
/// vanishes, at 1 / share in natural coordinates, shape functions branch.
pub(super) fn distortion(corners: &[Point; 4]) -> f64 {
    let at = |k: usize| {
        let [a, b, c] = [(k + 3) % 4, k, (k + 1) % 4].map(|i| corners[i]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    let [least, most] = range([0, 1, 2, 3].map(at));
    ((most - least) / (most + least).abs()).abs()
}

/// A rule that is right to rounding on facets of this `distortion`; `None` where products of shape functions are
/// polynomials. Gauss' rule of n points is off by ρ^(−2n), ρ being the sum of the half axes of the ellipse in which the
/// integrand is smooth (Trefethen, SIAM Review 50 (2008) 67).
pub(super) fn close(distortion: f64) -> Option<&'static [RulePoint]> {
    const PARALLELOGRAM: f64 = 1e-12;
    if distortion < PARALLELOGRAM {
        return None;
    }
    let branch = 1.0 / distortion.min(0.99);
    let ellipse = branch + (branch * branch - 1.0).sqrt();
    let points = (-0.5 * ROUNDING.ln() / ellipse.ln()).ceil() as usize + 3;
    Some(folded(points.min(MOST_POINTS)))
}

/// Gauss' rule of `points` on a square of which one side shrinks to a corner (Stroud, *Approximate Calculation of Multiple
/// Integrals*, 1971).
fn folded(points: usize) -> &'static [RulePoint] {
    static RULES: [OnceLock<Vec<RulePoint>>; MOST_POINTS + 1] =
        [const { OnceLock::new() }; MOST_POINTS + 1];
    RULES[points].get_or_init(|| {
        let line = legendre(points);
        let mut rule = Vec::with_capacity(points * points);
        for (u, a) in &line {
            for (v, b) in &line {
                rule.push(([1.0 - u, u * (1.0 - v), u * v], 2.0 * u * a * b));
            }
        }
        rule
    })
}

/// Gauss' points and weights on [0, 1]: roots of Legendre's polynomial, by Newton's method.
fn legendre(points: usize) -> Vec<(f64, f64)> {
    const ITERATIONS: usize = 50;
    let n = points as f64;
    let root = |k: usize| {
        let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..ITERATIONS {
            let (mut before, mut value) = (1.0, x);
            for i in 2..=points {
                let i = i as f64;
                (before, value) = (
                    value,
                    ((2.0 * i - 1.0) * x * value - (i - 1.0) * before) / i,
                );
            }
            slope = n * (before - x * value) / (1.0 - x * x);
            x -= value / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..points).map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x^a y^b over the unit triangle is a! b! / (a + b + 2)!, whose area is a half.
    #[test]
    fn high_powers_are_integrated_exactly() {
        let factorial = |n: u32| (1..=n).map(f64::from).product::<f64>();
        for (a, b) in [(0, 0), (3, 4), (10, 0), (7, 7)] {
            let exact = factorial(a) * factorial(b) / factorial(a + b + 2);
            let points = folded(8).iter();
            let sum: f64 = points
                .map(|([_, x, y], w)| 0.5 * w * x.powi(a as i32) * y.powi(b as i32))
                .sum();
            assert!((sum / exact - 1.0).abs() < 1e-13, "{a} {b}: {sum} {exact}");
        }
    }
}
