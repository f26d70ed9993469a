//! What is read from a solution of problem H, and how right it is: one measure for all programs.

use crate::frd::Fields;
use brinell::model::material::{Steel, mises};
use brinell::model::mesh::Mesh;
use brinell::proof::verify::problem_h::{HALF_WIDTH, POISSON, PRESSURE, YOUNG};
use brinell::solver::fem::hex8::Geometry;

/// The two readings of the Mises stress.
pub const READINGS: [&str; 2] = ["nodal", "centroid"];

/// p0 in ksi and half-width in inches; then, by reading, the largest Mises stress of block and
/// cylinder in ksi.
#[derive(Debug, Clone, Copy)]
pub struct Values {
    pub contact: [f64; 2],
    pub mises: [[f64; 2]; 2],
}

/// Hertz's p0 and half-width; the Mises stress of the finite bodies, 1.98 % above and 0.38 % below
/// Hertz's 93.20 ksi.
pub const LIMITS: Values = Values {
    contact: [PRESSURE, HALF_WIDTH],
    mises: [[95.05, 92.85]; 2],
};

/// Are p0, half-width and both Mises stresses of a reading right to the share `goal`?
pub fn within(values: &Values, reading: usize, goal: f64) -> bool {
    let near = |(value, limit): (&f64, &f64)| (value / limit - 1.0).abs() <= goal;
    let contact = values.contact.iter().zip(&LIMITS.contact).all(near);
    let mises = values.mises[reading].iter().zip(&LIMITS.mises[reading]);
    contact && mises.into_iter().all(near)
}

/// Reads fields of CalculiX with mortar contact.
pub fn of_fields(mesh: &Mesh, fields: &Fields) -> Result<Values, String> {
    // Dual multipliers: each pressure belongs to the length of its node.
    let width = half_width(mesh, &fields.pressure, Basis::Lumped)?;
    let mut values = Values {
        contact: [fields.peak_pressure(), width],
        mises: [[0.0; 2]; 2],
    };
    for (i, name) in ["block", "cylinder"].into_iter().enumerate() {
        values.mises[0][i] = nodal(mesh, fields, name);
        values.mises[1][i] = centroid(mesh, fields, name);
    }
    Ok(values)
}

/// Largest nodal Mises stress of a body.
pub fn nodal(mesh: &Mesh, fields: &Fields, body: &str) -> f64 {
    let mut inside = vec![false; mesh.points.len()];
    let elements = mesh.body(body).map(|b| mesh.bodies[b].elements.clone());
    for node in mesh.hexes[elements.unwrap_or(0..0)].iter().flatten() {
        inside[*node as usize] = true;
    }
    fields.peak_mises(|node| inside[node])
}

/// Largest Mises stress of an element's mean, from the displacements: the file has no others. Its
/// six digits make it good to 0.05 % on these meshes.
fn centroid(mesh: &Mesh, fields: &Fields, body: &str) -> f64 {
    let elastic = Steel::elastic(YOUNG, POISSON).moduli();
    let elements = mesh.body(body).map(|b| mesh.bodies[b].elements.clone());
    let of = |element: usize| {
        let gradients = Geometry::new(&mesh.corners(element)).mean_gradients;
        let mut d = [[0.0; 3]; 3];
        for (node, gradient) in mesh.hexes[element].iter().zip(gradients) {
            let u = fields.displacement[*node as usize];
            for i in 0..3 {
                for j in 0..3 {
                    d[i][j] += u[i] * gradient[j];
                }
            }
        }
        let shear = |i: usize, j: usize| d[i][j] + d[j][i];
        let strain = [
            d[0][0],
            d[1][1],
            d[2][2],
            shear(0, 1),
            shear(1, 2),
            shear(2, 0),
        ];
        mises(&elastic.stress(&strain))
    };
    elements.unwrap_or(0..0).map(of).fold(0.0, f64::max)
}

/// The basis that carries a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Basis {
    /// Linear between the nodes.
    Hat,
    /// All of it at the nodes.
    Lumped,
}

/// 2 √(∫ p x² / ∫ p) of the nodal pressures on the face z = 0.
pub fn half_width(mesh: &Mesh, pressure: &[f64], basis: Basis) -> Result<f64, String> {
    let surface = mesh
        .surface("cylinder_contact")
        .ok_or("no contact surface")?;
    let nodes = surface.nodes().into_iter().map(|n| n as usize);
    let mut line: Vec<[f64; 2]> = nodes
        .filter(|n| mesh.points[*n][2].abs() < 1e-9)
        .map(|n| [mesh.points[n][0], pressure.get(n).copied().unwrap_or(0.0)])
        .collect();
    line.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut force, mut second) = (0.0, 0.0);
    for w in line.windows(2) {
        let ([x0, p0], [x1, p1]) = (w[0], w[1]);
        let (x, p) = (0.5 * (x0 + x1), 0.5 * (p0 + p1));
        let length = x1 - x0;
        force += length * p;
        let ends = p0 * x0 * x0 + p1 * x1 * x1;
        second += match basis {
            // Simpson's rule is exact for a cubic.
            Basis::Hat => length / 6.0 * (ends + 4.0 * p * x * x),
            Basis::Lumped => 0.5 * length * ends,
        };
    }
    Ok(2.0 * (second / force).sqrt())
}
