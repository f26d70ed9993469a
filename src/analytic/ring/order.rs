//! One order of Michell's series.

use nalgebra::{Matrix4, Vector4};

/// Constants A, B, C, D of the terms (r/r_o)ⁿ, (r_i/r)ⁿ and the same times (r/r_o)², in units of
/// r_o² for the stress function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Order {
    /// A and C of the solid disc.
    pub disc: [f64; 2],
    /// What frees the inner wall from the disc's tractions.
    pub bore: [f64; 4],
}

impl Order {
    /// Order n under the radial stress -`pressure` cos nθ on the outer wall, for the ratio `bore`
    /// of the radii.
    pub fn new(n: f64, bore: f64, pressure: f64) -> Self {
        let disc = [0.5 * pressure / (n - 1.0), -0.5 * pressure / (n + 1.0)];
        let reach = bore.powf(n);
        // The disc's stress at the inner wall is far below the last digit.
        if reach < 1e-30 {
            return Self {
                disc,
                bore: [0.0; 4],
            };
        }
        // Coefficients of A, B, C, D in the two stresses at x = r/r_o, where the powers are p, q.
        let radial = |x: f64, p: f64, q: f64| {
            let (low, high) = (n * (n - 1.0) / (x * x), n * (n + 1.0) / (x * x));
            [
                -low * p,
                -high * q,
                (n + 2.0 - n * n) * p,
                (2.0 - n - n * n) * q,
            ]
        };
        let shear = |x: f64, p: f64, q: f64| {
            let (low, high) = (n * (n - 1.0) / (x * x), n * (n + 1.0) / (x * x));
            [low * p, -high * q, n * (n + 1.0) * p, n * (1.0 - n) * q]
        };
        let inner = [radial(bore, reach, 1.0), shear(bore, reach, 1.0)];
        let left = inner.map(|row| -(row[0] * disc[0] + row[2] * disc[1]));
        let rows = [
            radial(1.0, 1.0, reach),
            shear(1.0, 1.0, reach),
            inner[0],
            inner[1],
        ];
        let matrix = Matrix4::from_fn(|i, j| rows[i][j]);
        let right = Vector4::new(0.0, 0.0, left[0], left[1]);
        // Regular for every n of 2 and more and 0 < bore < 1.
        let bore = matrix.lu().solve(&right).unwrap_or_default();
        Self {
            disc,
            bore: bore.into(),
        }
    }
}
