//! Hex8 with incompatible modes, the element that "C3D8I" stands for.
//!
//! To the trilinear displacement come the three bubbles 1 − ξ_m², each along x, y and z: nine
//! inner unknowns, which let the element bend without shear. Their gradients are taken with the
//! Jacobian J₀ at the centre and scaled by the determinants, ∇N_m = −2 ξ_m (j₀/j) J₀⁻ᵀ e_m, so
//! that a constant stress does no work on them and distorted meshes pass the patch test
//! (Taylor, Beresford, Wilson, *A non-conforming element for stress analysis*, IJNME 10 (1976)
//! 1211; as enhanced strains: Simo and Rifai, IJNME 29 (1990) 1595).
//!
//! The bubbles cannot take up the bilinear part of the volumetric strain, which would lock where
//! the material flows or is incompressible. So the volumetric strain is replaced by its
//! least-squares fit in 1, ξ, η, ζ over the element: what Andelfinger and Ramm (IJNME 36 (1993)
//! 1311) reach with three more volumetric modes, without their unknowns.
//!
//! In the formulas a bubble is a ninth, tenth and eleventh node. The inner unknowns are eliminated
//! in the element, see `condense` and `relax`. Tensors are stored xx yy zz xy yz zx; strains
//! carry engineering shears.

mod condense;
mod relax;
#[cfg(test)]
mod tests;

use super::bbar::ElementVector;
use super::hex8::{Geometry, invert};
use crate::model::material::matrix;
use crate::model::mesh::hexahedron::{CORNERS, GAUSS, jacobian_matrix, shape_derivatives};
use crate::solver::linear::small::SmallCholesky;
use std::ops::Range;

/// Corners and bubbles.
const NODES: usize = 11;
const BUBBLES: Range<usize> = 8..NODES;

/// Displacements or forces of corners and bubbles: node by node, x y z.
type Field = [[f64; 3]; NODES];

/// The element's shape, at its eight integration points.
#[derive(Debug, Clone)]
pub struct Enhanced {
    /// ∂N/∂x_i of corners and bubbles.
    gradients: [Field; 8],
    /// What the volumetric strain is taken with: the fit of `gradients` in 1, ξ, η, ζ.
    volumetric: [Field; 8],
    /// Volume that each integration point stands for.
    pub(super) volumes: [f64; 8],
}

impl Enhanced {
    /// From the corner coordinates of a valid (not inverted) element.
    pub fn new(corners: &[[f64; 3]; 8]) -> Self {
        let geometry = Geometry::new(corners);
        let (inverse, det) = invert(&jacobian_matrix(corners, &shape_derivatives([0.0; 3])));
        let mut gradients = [[[0.0; 3]; NODES]; 8];
        for (k, at) in gradients.iter_mut().enumerate() {
            at[..8].copy_from_slice(&geometry.gradients[k]);
            let scale = -2.0 * GAUSS * det / geometry.volumes[k];
            for (m, row) in inverse.iter().enumerate() {
                at[8 + m] = row.map(|d| scale * CORNERS[k][m] * d);
            }
        }
        Self {
            volumetric: linear_fit(&gradients, &geometry.volumes),
            gradients,
            volumes: geometry.volumes,
        }
    }

    /// Strain at integration point `k`.
    fn strain(&self, k: usize, u: &Field) -> [f64; 6] {
        let mut d = [[0.0; 3]; 3];
        let mut volume = 0.0;
        for ((u, g), v) in u.iter().zip(&self.gradients[k]).zip(&self.volumetric[k]) {
            for i in 0..3 {
                for j in 0..3 {
                    d[i][j] += u[i] * g[j];
                }
                volume += u[i] * v[i];
            }
        }
        let shift = (volume - d[0][0] - d[1][1] - d[2][2]) / 3.0;
        [
            d[0][0] + shift,
            d[1][1] + shift,
            d[2][2] + shift,
            d[0][1] + d[1][0],
            d[1][2] + d[2][1],
            d[2][0] + d[0][2],
        ]
    }

    /// Bᵀσ of integration point `k` at `node`, per volume.
    fn stress_force(&self, k: usize, node: usize, s: &[f64; 6]) -> [f64; 3] {
        let tensor = matrix(*s);
        let pressure = (s[0] + s[1] + s[2]) / 3.0;
        let (d, v) = (self.gradients[k][node], self.volumetric[k][node]);
        std::array::from_fn(|i| {
            let plain = tensor[i][0] * d[0] + tensor[i][1] * d[1] + tensor[i][2] * d[2];
            plain + pressure * (v[i] - d[i])
        })
    }

    /// Adds the forces of `stress` at integration point `k` on corners and bubbles.
    fn add_stress_force(&self, k: usize, stress: &[f64; 6], force: &mut Field) {
        for (node, f) in force.iter_mut().enumerate() {
            for (f, s) in f.iter_mut().zip(self.stress_force(k, node, stress)) {
                *f += self.volumes[k] * s;
            }
        }
    }
}

/// The corners move by `u`, the bubbles not yet.
fn field(u: &ElementVector) -> Field {
    let mut field = [[0.0; 3]; NODES];
    field[..8].copy_from_slice(u);
    field
}

/// Least-squares fit, weighted by `volumes`, of values at the integration points in 1, ξ, η, ζ.
fn linear_fit(values: &[Field; 8], volumes: &[f64; 8]) -> [Field; 8] {
    let bases = CORNERS.map(|c| [1.0, c[0], c[1], c[2]]);
    let mut gram = [[0.0; 4]; 4];
    for (base, volume) in bases.iter().zip(volumes) {
        for i in 0..4 {
            for j in 0..4 {
                gram[i][j] += volume * base[i] * base[j];
            }
        }
    }
    let Some(gram) = SmallCholesky::new(gram) else {
        // Only where a volume is not positive: such an element is refused with its mesh.
        return *values;
    };
    let mut fit = [[[0.0; 3]; NODES]; 8];
    for ((base, volume), values) in bases.iter().zip(volumes).zip(values) {
        let mut dual = *base;
        gram.solve(&mut dual);
        for (out, base) in fit.iter_mut().zip(&bases) {
            let weight = volume * (0..4).map(|i| base[i] * dual[i]).sum::<f64>();
            for (out, value) in out.as_flattened_mut().iter_mut().zip(values.as_flattened()) {
                *out += weight * value;
            }
        }
    }
    fit
}
