//! Stiffness of corners and bubbles, and the bubbles' elimination: K_uu − K_ua K_aa⁻¹ K_au.

use super::{BUBBLES, Enhanced, NODES};
use crate::model::material::Moduli;
use crate::model::material::j2::Flow;
use crate::solver::fem::bbar::{ElementMatrix, add_outer};
use crate::solver::linear::small::SmallCholesky;

const SIZE: usize = 3 * NODES;
/// Inner unknowns: three bubbles along three axes.
pub(super) const INNER: usize = 9;

/// Stiffness of corners and bubbles; only entries with row node >= column node are set.
type Whole = [[f64; SIZE]; SIZE];
pub(super) type InnerMatrix = [[f64; INNER]; INNER];

/// Share of the elastic stiffness that is added to the bubbles' tangent: a perfectly plastic
/// element can flow with its bubbles at no cost. Forces do not contain it.
pub(super) const SHIFT: f64 = 1e-9;

impl Enhanced {
    /// Elastic stiffness of the corners.
    pub fn stiffness(&self, elastic: &Moduli) -> ElementMatrix {
        let mut whole = [[0.0; SIZE]; SIZE];
        self.add_elastic(elastic, &[1.0; 8], &mut whole);
        condense(&whole)
    }

    /// Consistent tangent minus the elastic stiffness, both of the corners.
    pub fn tangent_change(&self, elastic: &Moduli, flows: &[Option<Flow>; 8]) -> ElementMatrix {
        let mut whole = [[0.0; SIZE]; SIZE];
        let betas = flows.map(|f| f.map_or(1.0, |f| f.beta));
        self.add_elastic(elastic, &betas, &mut whole);
        for (k, flow) in flows.iter().enumerate() {
            let Some(flow) = flow else { continue };
            let factor = flow.softening * self.volumes[k];
            let b: [[f64; 3]; NODES] =
                std::array::from_fn(|a| self.stress_force(k, a, &flow.direction));
            add_outer(b.as_flattened(), -factor, &mut whole);
        }
        let elastic_inner = self.inner_stiffness(elastic);
        for (i, shift) in elastic_inner.iter().enumerate() {
            for (value, shift) in whole[24 + i][24..].iter_mut().zip(shift) {
                *value += SHIFT * shift;
            }
        }
        let mut change = condense(&whole);
        for (row, elastic) in change.iter_mut().zip(self.stiffness(elastic)) {
            for (value, elastic) in row.iter_mut().zip(elastic) {
                *value -= elastic;
            }
        }
        change
    }

    /// K_aa of the bubbles: elastic.
    pub(super) fn inner_stiffness(&self, elastic: &Moduli) -> InnerMatrix {
        self.inner_tangent(elastic, &[None; 8])
    }

    /// K_aa of the bubbles: consistent with `flows`.
    pub(super) fn inner_tangent(&self, elastic: &Moduli, flows: &[Option<Flow>; 8]) -> InnerMatrix {
        let mut inner = [[0.0; INNER]; INNER];
        for (k, flow) in flows.iter().enumerate() {
            let beta = flow.map_or(1.0, |f| f.beta);
            for a in BUBBLES {
                for b in BUBBLES.start..=a {
                    let block = self.couple(k, a, b, beta * elastic.shear, elastic.bulk);
                    add_block(&block, [a - 8, b - 8], &mut inner);
                }
            }
            let Some(flow) = flow else { continue };
            let factor = flow.softening * self.volumes[k];
            let b: [[f64; 3]; 3] =
                std::array::from_fn(|m| self.stress_force(k, 8 + m, &flow.direction));
            add_outer(b.as_flattened(), -factor, &mut inner);
        }
        inner
    }

    /// Adds the stiffness with the shear modulus times `betas` at each point.
    fn add_elastic(&self, elastic: &Moduli, betas: &[f64; 8], whole: &mut Whole) {
        for (k, beta) in betas.iter().enumerate() {
            for a in 0..NODES {
                for b in 0..=a {
                    let block = self.couple(k, a, b, beta * elastic.shear, elastic.bulk);
                    add_block(&block, [a, b], whole);
                }
            }
        }
    }

    /// Stiffness of integration point `k` between two nodes, 2G I_dev + K 1⊗1.
    fn couple(&self, k: usize, a: usize, b: usize, shear: f64, bulk: f64) -> [[f64; 3]; 3] {
        let (da, db) = (&self.gradients[k][a], &self.gradients[k][b]);
        let (va, vb) = (&self.volumetric[k][a], &self.volumetric[k][b]);
        let dot = da[0] * db[0] + da[1] * db[1] + da[2] * db[2];
        let (shear, bulk) = (shear * self.volumes[k], bulk * self.volumes[k]);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let same = if i == j { dot } else { 0.0 };
                let deviatoric = same + da[j] * db[i] - 2.0 / 3.0 * da[i] * db[j];
                shear * deviatoric + bulk * va[i] * vb[j]
            })
        })
    }
}

/// Adds what couples two nodes.
fn add_block<const N: usize>(block: &[[f64; 3]; 3], [a, b]: [usize; 2], to: &mut [[f64; N]; N]) {
    for (i, row) in block.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            to[3 * a + i][3 * b + j] += value;
        }
    }
}

/// Eliminates the bubbles.
fn condense(whole: &Whole) -> ElementMatrix {
    let mut matrix: ElementMatrix =
        std::array::from_fn(|i| std::array::from_fn(|j| whole[i.max(j)][i.min(j)]));
    let inner = std::array::from_fn(|i| std::array::from_fn(|j| whole[24 + i][24 + j]));
    // A valid shape and a tangent with its shift are positive definite; otherwise the bubbles
    // stay put.
    let Some(inner) = SmallCholesky::<INNER>::new(inner) else {
        return matrix;
    };
    for j in 0..24 {
        let mut x: [f64; INNER] = std::array::from_fn(|i| whole[24 + i][j]);
        inner.solve(&mut x);
        for i in j..24 {
            let sum: f64 = (0..INNER).map(|m| whole[24 + m][i] * x[m]).sum();
            matrix[i][j] -= sum;
            if i > j {
                matrix[j][i] -= sum;
            }
        }
    }
    matrix
}
