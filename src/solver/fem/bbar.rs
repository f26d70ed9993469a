//! Hex8 with the element-mean volumetric strain (B-bar), or plain and fully integrated.
//!
//! In B-bar the volumetric part of the strain is replaced by its mean over the element,
//! ε̄ = ∇ˢu + ⅓ (θ̄ − θ) I with θ̄ = (1/V) ∫ div u dV
//! (Hughes, *The Finite Element Method*, 1987, section 4.5; the mean-dilatation form).
//! In the plain element θ̄ is θ; CalculiX 2.20's C3D8 is that one, and agrees with it to 0.4 % where
//! B-bar differs by 12 % (nodal Mises stress on the bore of a roller, plastic contact).
//! Tensors are stored xx yy zz xy yz zx; strains carry engineering shears.

use super::hex8::Geometry;
use crate::model::material::{Moduli, matrix};

/// An element's forces or displacements: node by node, x y z.
pub type ElementVector = [[f64; 3]; 8];
/// An element's stiffness: row node, row component, column node, column component.
pub type ElementMatrix = [[f64; 24]; 24];

/// Strain at integration point `k` for nodal displacements `u`.
pub fn strain(g: &Geometry, k: usize, u: &ElementVector) -> [f64; 6] {
    let mut d = [[0.0; 3]; 3];
    let mut mean = 0.0;
    let dilatation = g.dilatation(k);
    for a in 0..8 {
        for i in 0..3 {
            for j in 0..3 {
                d[i][j] += u[a][i] * g.gradients[k][a][j];
            }
            mean += u[a][i] * dilatation[a][i];
        }
    }
    let shift = (mean - d[0][0] - d[1][1] - d[2][2]) / 3.0;
    [
        d[0][0] + shift,
        d[1][1] + shift,
        d[2][2] + shift,
        d[0][1] + d[1][0],
        d[1][2] + d[2][1],
        d[2][0] + d[0][2],
    ]
}

/// Adds B̄ᵀσ times the volume of integration point `k` to `force`.
pub(super) fn add_stress_force(
    g: &Geometry,
    k: usize,
    stress: &[f64; 6],
    force: &mut ElementVector,
) {
    let tensor = matrix(*stress);
    let pressure = (stress[0] + stress[1] + stress[2]) / 3.0;
    let volume = g.volumes[k];
    let dilatation = g.dilatation(k);
    for (a, f) in force.iter_mut().enumerate() {
        let d = g.gradients[k][a];
        for i in 0..3 {
            let plain = tensor[i][0] * d[0] + tensor[i][1] * d[1] + tensor[i][2] * d[2];
            f[i] += volume * (plain + pressure * (dilatation[a][i] - d[i]));
        }
    }
}

/// Elastic stiffness of the element.
pub fn stiffness(g: &Geometry, elastic: &Moduli) -> ElementMatrix {
    let mut matrix = [[0.0; 24]; 24];
    for k in 0..8 {
        add_deviatoric(g, k, elastic.shear * g.volumes[k], &mut matrix);
    }
    if g.mean_dilatation {
        add_dilatation(&g.mean_gradients, elastic.bulk * g.volume, &mut matrix);
    } else {
        for (gradients, volume) in g.gradients.iter().zip(g.volumes) {
            add_dilatation(gradients, elastic.bulk * volume, &mut matrix);
        }
    }
    matrix
}

/// Adds `factor` (div u)², its gradients being `d`.
fn add_dilatation(d: &[[f64; 3]; 8], factor: f64, matrix: &mut ElementMatrix) {
    add_outer(d.as_flattened(), factor, matrix);
}

/// Adds `factor` b bᵀ.
pub(super) fn add_outer<const N: usize>(b: &[f64], factor: f64, matrix: &mut [[f64; N]; N]) {
    for (row, bi) in matrix.iter_mut().zip(b) {
        for (value, bj) in row.iter_mut().zip(b) {
            *value += factor * bi * bj;
        }
    }
}

/// Adds `factor` ∫ 2 dev ε : dev ε of integration point `k` (its shear stiffness for factor G V).
pub(super) fn add_deviatoric(g: &Geometry, k: usize, factor: f64, matrix: &mut ElementMatrix) {
    for a in 0..8 {
        let da = g.gradients[k][a];
        for b in 0..8 {
            let db = g.gradients[k][b];
            let dot = da[0] * db[0] + da[1] * db[1] + da[2] * db[2];
            for i in 0..3 {
                for j in 0..3 {
                    let value = da[j] * db[i] - 2.0 / 3.0 * da[i] * db[j];
                    matrix[3 * a + i][3 * b + j] += factor * value;
                }
                matrix[3 * a + i][3 * b + i] += factor * dot;
            }
        }
    }
}

/// Adds `factor` (Bᵀn)(Bᵀn)ᵀ at integration point `k` for a deviatoric stress direction `n`.
pub(super) fn add_direction(
    g: &Geometry,
    k: usize,
    n: &[f64; 6],
    factor: f64,
    matrix: &mut ElementMatrix,
) {
    let mut b = [[0.0; 3]; 8];
    add_stress_force(g, k, n, &mut b);
    let b = b.map(|node| node.map(|v| v / g.volumes[k]));
    add_outer(b.as_flattened(), factor, matrix);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Steel;
    use crate::model::mesh::hexahedron::CORNERS;

    fn distorted() -> [[f64; 3]; 8] {
        let mut c = CORNERS;
        for (a, x) in c.iter_mut().enumerate() {
            let t = a as f64;
            x[0] += 0.1 * (t * 1.3).sin();
            x[1] += 0.1 * (t * 2.1).cos();
            x[2] += 0.1 * (t * 0.7).sin();
        }
        c
    }

    #[test]
    fn stiffness_times_displacement_equals_the_force_of_the_stress() {
        let elastic = Steel::elastic(200.0, 0.3).moduli();
        let u: ElementVector =
            std::array::from_fn(|a| std::array::from_fn(|i| ((a * 3 + i) as f64 * 0.77).sin()));
        for g in [Geometry::new(&distorted()), Geometry::plain(&distorted())] {
            let k = stiffness(&g, &elastic);
            let mut force = [[0.0; 3]; 8];
            for p in 0..8 {
                add_stress_force(&g, p, &elastic.stress(&strain(&g, p, &u)), &mut force);
            }
            for a in 0..8 {
                for i in 0..3 {
                    let row: f64 = (0..24).map(|c| k[3 * a + i][c] * u[c / 3][c % 3]).sum();
                    assert!((row - force[a][i]).abs() < 1e-11 * 200.0);
                }
            }
        }
    }

    #[test]
    fn rigid_motion_costs_nothing() {
        let g = Geometry::new(&distorted());
        let u = distorted().map(|x| [1.0 - 0.2 * x[1], 0.2 * x[0] + 0.1 * x[2], -0.1 * x[1]]);
        for k in 0..8 {
            assert!(strain(&g, k, &u).iter().all(|e| e.abs() < 1e-14));
        }
    }
}
