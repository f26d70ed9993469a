//! The trilinear hexahedron at its 2×2×2 Gauss points: gradients and volumes for the solver.

pub use crate::model::mesh::hexahedron::{CORNERS, GAUSS, shape, shape_derivatives};

use crate::model::mesh::hexahedron::jacobian_matrix;

/// Geometry of one element at its eight integration points.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// ∂N_a/∂x_i at each integration point.
    pub gradients: [[[f64; 3]; 8]; 8],
    /// Volume that each integration point stands for: det J times the Gauss weight.
    pub volumes: [f64; 8],
    /// Gradients averaged over the element's volume.
    pub mean_gradients: [[f64; 3]; 8],
    /// Volume of the element.
    pub volume: f64,
    /// Is the volumetric strain the element's mean (B-bar), or that of each integration point?
    pub mean_dilatation: bool,
}

impl Geometry {
    /// From the corner coordinates of a valid (not inverted) element, with mean dilatation.
    pub fn new(corners: &[[f64; 3]; 8]) -> Self {
        let mut g = Self {
            gradients: [[[0.0; 3]; 8]; 8],
            volumes: [0.0; 8],
            mean_gradients: [[0.0; 3]; 8],
            volume: 0.0,
            mean_dilatation: true,
        };
        for (k, corner) in CORNERS.iter().enumerate() {
            let dn = shape_derivatives(corner.map(|c| c * GAUSS));
            let (inverse, det) = invert(&jacobian_matrix(corners, &dn));
            g.volumes[k] = det;
            g.volume += det;
            for a in 0..8 {
                for i in 0..3 {
                    let d = (0..3).map(|j| dn[a][j] * inverse[j][i]).sum::<f64>();
                    g.gradients[k][a][i] = d;
                    g.mean_gradients[a][i] += det * d;
                }
            }
        }
        for d in g.mean_gradients.iter_mut().flatten() {
            *d /= g.volume;
        }
        g
    }

    /// Fully integrated: the volumetric strain is that of each integration point.
    pub fn plain(corners: &[[f64; 3]; 8]) -> Self {
        Self {
            mean_dilatation: false,
            ..Self::new(corners)
        }
    }

    /// Gradients that make the volumetric strain at integration point `k`.
    pub fn dilatation(&self, k: usize) -> &[[f64; 3]; 8] {
        match self.mean_dilatation {
            true => &self.mean_gradients,
            false => &self.gradients[k],
        }
    }
}

/// Inverse and determinant of a 3×3 matrix.
pub(super) fn invert(m: &[[f64; 3]; 3]) -> ([[f64; 3]; 3], f64) {
    let cofactor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (c, d) = ((j + 1) % 3, (j + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let det = (0..3).map(|j| m[0][j] * cofactor(0, j)).sum::<f64>();
    let mut inverse = [[0.0; 3]; 3];
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value = cofactor(j, i) / det;
        }
    }
    (inverse, det)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheared_brick_has_its_exact_volume_and_linear_gradients() {
        // x = (2u + 0.3v, 3v, 4w + 0.1u): volume 8 * det.
        let corners =
            CORNERS.map(|c| [2.0 * c[0] + 0.3 * c[1], 3.0 * c[1], 4.0 * c[2] + 0.1 * c[0]]);
        let g = Geometry::new(&corners);
        assert!((g.volume - 8.0 * 24.0).abs() < 1e-11);
        for k in 0..8 {
            for i in 0..3 {
                for j in 0..3 {
                    let d: f64 = (0..8).map(|a| corners[a][i] * g.gradients[k][a][j]).sum();
                    assert!((d - f64::from(u8::from(i == j))).abs() < 1e-13);
                }
            }
        }
    }
}
