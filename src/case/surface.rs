//! Is a surface of the mesh flat or curved?

use crate::mesh::{Mesh, Surface};

/// Facets of a flat surface are parallel up to this angle, in radians.
const FLAT: f64 = 1e-5;

/// Do the facets of the surface point in different directions?
pub(super) fn is_curved(mesh: &Mesh, surface: &Surface) -> bool {
    let mut normals = surface
        .faces
        .iter()
        .filter_map(|face| normal(mesh, face.nodes));
    let Some(first) = normals.next() else {
        return false;
    };
    normals.any(|other| {
        let tilt = cross(first, other);
        let turned: f64 = first.iter().zip(other).map(|(a, b)| a * b).sum();
        turned < 0.0 || tilt.iter().fold(0.0, |sum: f64, c| sum.hypot(*c)) > FLAT
    })
}

/// The unit normal of a facet, from its diagonals; `None` where it has no area.
fn normal(mesh: &Mesh, nodes: [u32; 4]) -> Option<[f64; 3]> {
    let point = |i: usize| mesh.points.get(nodes[i] as usize).copied();
    let (a, b, c, d) = (point(0)?, point(1)?, point(2)?, point(3)?);
    let between = |p: [f64; 3], q: [f64; 3]| [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
    let n = cross(between(a, c), between(b, d));
    let length = n.iter().fold(0.0, |sum: f64, c| sum.hypot(*c));
    (length > 0.0).then(|| n.map(|c| c / length))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
