//! The modes against published numbers, and what the fit of the volumetric strain is for.

use super::{BUBBLES, Enhanced, NODES};
use crate::model::material::j2::PlasticPoint;
use crate::model::material::{Moduli, Steel};
use crate::model::mesh::block::{Block, uniform};
use crate::model::mesh::hexahedron::CORNERS;
use nalgebra::{DMatrix, DVector, SMatrix};

/// The element of Taylor, Beresford and Wilson: the volumetric strain as it comes.
fn without_fit(corners: &[[f64; 3]; 8]) -> Enhanced {
    let mut element = Enhanced::new(corners);
    element.volumetric = element.gradients;
    element
}

fn distorted() -> [[f64; 3]; 8] {
    let mut c = CORNERS;
    for (a, x) in c.iter_mut().enumerate() {
        let t = a as f64;
        x[0] += 0.2 * (t * 1.3).sin();
        x[1] += 0.2 * (t * 2.1).cos();
        x[2] += 0.2 * (t * 0.7).sin();
    }
    c
}

/// The regular cantilever of MacNeal and Harder (1985), 6 × 0.2 × 0.1 of six elements: tip over
/// theory for extension and the two bendings, as published for the HEX8 of OptiStruct
/// (verification problem OS-V:0720).
#[test]
fn without_the_fit_it_is_the_published_element() {
    let [x, y, z] = [(6.0, 6), (0.2, 1), (0.1, 1)].map(|(l, n)| uniform(0.0, l, n));
    let mesh = Block::new("beam", x, y, z).build().expect("a valid block");
    let elastic = Steel::elastic(1e7, 0.3).moduli();
    let size = 3 * mesh.points.len();
    let mut matrix = DMatrix::zeros(size, size);
    for (e, nodes) in mesh.hexes.iter().enumerate() {
        let block = without_fit(&mesh.corners(e)).stiffness(&elastic);
        let equation = |i: usize| 3 * nodes[i / 3] as usize + i % 3;
        for (i, row) in block.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                matrix[(equation(i), equation(j))] += value;
            }
        }
    }
    for (node, point) in mesh.points.iter().enumerate() {
        for i in (3 * node..3 * node + 3).filter(|_| point[0] == 0.0) {
            matrix.row_mut(i).fill(0.0);
            matrix.column_mut(i).fill(0.0);
            matrix[(i, i)] = 1.0;
        }
    }
    let factor = matrix.cholesky().expect("a held beam");
    let tip: Vec<usize> = (0..mesh.points.len())
        .filter(|n| mesh.points[*n][0] == 6.0)
        .collect();
    for (axis, theory, published) in [
        (0, 3.0e-5, 0.9876),
        (1, 0.1081, 0.9782),
        (2, 0.4321, 0.9729),
    ] {
        let mut force = DVector::zeros(size);
        for node in &tip {
            force[3 * node + axis] = 0.25;
        }
        let u = factor.solve(&force);
        let mean: f64 = tip.iter().map(|n| 0.25 * u[3 * n + axis]).sum();
        let ratio = mean / theory;
        assert!((ratio - published).abs() < 6e-5, "{axis}: {ratio}");
    }
}

/// Modes that an incompressible element resists: the change of volume alone is allowed to.
/// Without the fit there are four.
#[test]
fn one_mode_locks() {
    let elastic = Moduli {
        shear: 1.0,
        bulk: 1e8,
    };
    let locked = |element: Enhanced| {
        let stiffness = element.stiffness(&elastic);
        let matrix = SMatrix::<f64, 24, 24>::from_fn(|i, j| stiffness[i][j]);
        let values = matrix.symmetric_eigenvalues();
        values.iter().filter(|v| **v > 1e4).count()
    };
    assert_eq!(locked(Enhanced::new(&CORNERS)), 1);
    assert_eq!(locked(without_fit(&CORNERS)), 4);
}

/// Six rigid motions cost nothing, everything else does.
#[test]
fn rank_is_eighteen() {
    let stiffness = Enhanced::new(&distorted()).stiffness(&Steel::elastic(1.0, 0.3).moduli());
    let values = SMatrix::<f64, 24, 24>::from_fn(|i, j| stiffness[i][j]).symmetric_eigenvalues();
    let free = values.iter().filter(|v| v.abs() < 1e-13).count();
    let stiff = values.iter().filter(|v| **v > 1e-3).count();
    assert_eq!((free, stiff), (6, 18));
}

/// A constant stress does no work on the bubbles, whatever the shape.
#[test]
fn bubbles_leave_a_constant_stress_alone() {
    let element = Enhanced::new(&distorted());
    let mut force = [[0.0; 3]; NODES];
    for k in 0..8 {
        element.add_stress_force(k, &[3.0, -2.0, 1.0, 0.5, 0.7, -4.0], &mut force);
    }
    assert!(
        force[BUBBLES]
            .as_flattened()
            .iter()
            .all(|f| f.abs() < 1e-13)
    );
}

/// The stress of a state is in balance with its bubbles and its corners' force.
#[test]
fn stress_and_force_agree_when_the_steel_flows() {
    let steel = Steel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: 100.0,
        hardening_modulus: 249.471,
    };
    let elastic = steel.moduli();
    let element = Enhanced::new(&distorted());
    let u = std::array::from_fn(|a| std::array::from_fn(|i| 0.05 * ((3 * a + i) as f64).sin()));
    let old = [PlasticPoint::default(); 8];
    let (points, flows) = element
        .answer(&steel, &elastic, &u, &old)
        .expect("a balance");
    assert!(flows.iter().any(Option::is_some));
    let mut force = [[0.0; 3]; NODES];
    for (k, stress) in element.stress(&elastic, &u, &points).iter().enumerate() {
        element.add_stress_force(k, stress, &mut force);
    }
    assert!(force[BUBBLES].as_flattened().iter().all(|f| f.abs() < 1e-9));
    let (stiffness, relief) = (
        element.stiffness(&elastic),
        element.relief(&elastic, &points),
    );
    for i in 0..24 {
        let row = stiffness[i].iter().zip(u.as_flattened());
        let composed = row.map(|(k, u)| k * u).sum::<f64>() - relief[i / 3][i % 3];
        assert!((composed - force[i / 3][i % 3]).abs() < 1e-9);
    }
}
