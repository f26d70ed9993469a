//! The trilinear hexahedron as results see it: shape functions and integration points.

pub use crate::model::mesh::hexahedron::{
    CORNERS, GAUSS, shape, shape_derivatives as natural_gradients,
};

/// Sums nodal vectors, or tensors, weighted by nodal values, such as a position from shape functions.
pub fn interpolate<const N: usize>(weights: &[f64; 8], nodal: &[[f64; N]; 8]) -> [f64; N] {
    let mut sum = [0.0; N];
    for (w, v) in weights.iter().zip(nodal) {
        for i in 0..N {
            sum[i] += w * v[i];
        }
    }
    sum
}

/// Tables of the 2x2x2 Gauss rule; integration point `k` lies at the side of corner `k`.
#[derive(Debug, Clone)]
pub struct GaussRule {
    /// Natural coordinates of each point.
    pub points: [[f64; 3]; 8],
    /// Shape functions at each point.
    pub shape: [[f64; 8]; 8],
    /// Natural gradients of the shape functions at each point.
    pub gradients: [[[f64; 3]; 8]; 8],
    /// `to_corners[a][k]`: weight of point `k` in the trilinear extrapolation to corner `a`.
    pub to_corners: [[f64; 8]; 8],
}

impl GaussRule {
    /// The tables, computed anew.
    pub fn new() -> Self {
        let points = CORNERS.map(|c| c.map(|x| x * GAUSS));
        Self {
            points,
            shape: points.map(shape),
            gradients: points.map(natural_gradients),
            to_corners: CORNERS.map(|c| shape(c.map(|x| x / GAUSS))),
        }
    }

    /// Position of integration point `point`.
    pub fn position(&self, point: usize, corners: &[[f64; 3]; 8]) -> [f64; 3] {
        interpolate(&self.shape[point], corners)
    }

    /// Values at the corners of the trilinear field through the integration points.
    pub fn extrapolate(&self, values: &[[f64; 6]; 8]) -> [[f64; 6]; 8] {
        self.to_corners.map(|weights| interpolate(&weights, values))
    }
}

impl Default for GaussRule {
    fn default() -> Self {
        Self::new()
    }
}

/// Mean of the corners, which is where the natural coordinates vanish.
pub fn centre(corners: &[[f64; 3]; 8]) -> [f64; 3] {
    interpolate(&[0.125; 8], corners)
}

/// Largest distance between two opposite corners.
pub fn diagonal(corners: &[[f64; 3]; 8]) -> f64 {
    [(0, 6), (1, 7), (2, 4), (3, 5)]
        .iter()
        .map(|&(a, b)| distance(corners[a], corners[b]))
        .fold(0.0, f64::max)
}

/// Distance of two points.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trilinear_field_is_extrapolated_exactly() {
        let field = |x: [f64; 3]| {
            let v = 1.0 + 2.0 * x[0] - x[1] + 0.5 * x[2] + x[0] * x[1] * x[2];
            [v, -v, 2.0 * v, 0.0, 1.0, x[0] * x[2]]
        };
        let rule = GaussRule::new();
        let at_corners = rule.extrapolate(&rule.points.map(field));
        for (found, corner) in at_corners.iter().zip(CORNERS) {
            for (a, b) in found.iter().zip(field(corner)) {
                assert!((a - b).abs() < 1e-13);
            }
        }
    }
}
