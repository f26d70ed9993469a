//! The force and moment that a rigid plane exerts.

use crate::ground::geometry::{Vec3, cross, sub};
use crate::model::mesh::Mesh;

/// What balances that which is `left` over at the nodes of `surface`, along `axes`; zero along other axes. Beside it
/// its moment about the point `about`.
pub fn reaction(
    mesh: &Mesh,
    left: &[Vec3],
    surface: &str,
    (axes, about): ([bool; 3], Vec3),
) -> [Vec3; 2] {
    let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
    let Some(surface) = mesh.surface(surface).filter(|_| axes != [false; 3]) else {
        return [sum, moment];
    };
    for node in surface.nodes() {
        let left = left[node as usize];
        let own = [0, 1, 2].map(|axis| if axes[axis] { -left[axis] } else { 0.0 });
        let turn = cross(sub(mesh.points[node as usize], about), own);
        for axis in 0..3 {
            sum[axis] += own[axis];
            moment[axis] += turn[axis];
        }
    }
    [sum, moment]
}
