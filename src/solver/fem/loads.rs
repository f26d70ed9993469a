//! Nodal forces: of surface tractions, and gathered from elements.

use crate::ground::geometry::{Vec3, cross, norm, scale};
use crate::model::mesh::hexahedron::GAUSS;
use crate::model::mesh::{Mesh, Surface, quadrilateral};
use crate::model::scene::TractionValue;

/// Nodes of an element, and the force on each of them.
pub type ElementForce = ([u32; 8], [Vec3; 8]);

/// The sum of the forces of elements at each of `count` nodes.
pub fn at_nodes(count: usize, elements: impl IntoIterator<Item = ElementForce>) -> Vec<Vec3> {
    let mut sum = vec![[0.0; 3]; count];
    for (nodes, forces) in elements {
        for (node, force) in nodes.iter().zip(forces) {
            let at = &mut sum[*node as usize];
            at.iter_mut().zip(force).for_each(|(s, f)| *s += f);
        }
    }
    sum
}

/// Adds the consistent nodal forces of a traction on `surface` to `force`.
pub fn add_traction(
    mesh: &Mesh,
    surface: &Surface,
    value: TractionValue,
    factor: f64,
    force: &mut [[f64; 3]],
) {
    for face in &surface.faces {
        let x = face.corners(mesh);
        for (n, normal) in face_points(&x) {
            let traction = match value {
                TractionValue::Pressure(p) => normal.map(|c| -p * c),
                TractionValue::Vector(t) => scale(t, norm(normal)),
            };
            for (node, n) in face.nodes.iter().zip(n) {
                for axis in 0..3 {
                    force[*node as usize][axis] += factor * n * traction[axis];
                }
            }
        }
    }
}

/// Area of a surface.
pub fn area(mesh: &Mesh, surface: &Surface) -> f64 {
    let faces = surface.faces.iter();
    faces
        .flat_map(|f| face_points(&f.corners(mesh)))
        .map(|(_, n)| norm(n))
        .sum()
}

/// The 2×2 Gauss points of a face: shape functions and the outward normal times the area that
/// the point stands for.
fn face_points(x: &[[f64; 3]; 4]) -> [([f64; 4], [f64; 3]); 4] {
    quadrilateral::CORNERS.map(|corner| {
        let s = corner.map(|c| c * GAUSS);
        let [along, across] = quadrilateral::derivatives(s, x);
        (quadrilateral::shape(s), cross(along, across))
    })
}
