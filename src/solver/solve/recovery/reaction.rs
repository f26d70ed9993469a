//! The force and moment that a rigid plane exerts.

use std::collections::BTreeMap;

use crate::ground::geometry::{Vec3, cross, sub};
use crate::model::mesh::Mesh;
use crate::model::scene::{PlaneMotion, Scene};

/// How many rigid planes move each node along each axis: what acts there is shared between them, so that forces add up.
pub struct SharedNodes(BTreeMap<u32, [u32; 3]>);

impl SharedNodes {
    /// Those of all planes of a scene.
    pub fn of(scene: &Scene) -> Self {
        let mut planes: BTreeMap<u32, [u32; 3]> = BTreeMap::new();
        for plane in &scene.rigid_planes {
            let moved = plane.motion.map(|m| u32::from(m != PlaneMotion::Free));
            for node in scene.mesh.nodes_of_surface(&plane.surface) {
                let count = planes.entry(node).or_default();
                (0..3).for_each(|axis| count[axis] += moved[axis]);
            }
        }
        Self(planes)
    }

    fn share(&self, node: u32, axis: usize) -> f64 {
        let planes = self.0.get(&node).map_or(1, |count| count[axis]);
        1.0 / f64::from(planes.max(1))
    }
}

/// What balances that which is `left` over at the nodes of `surface`, along `axes`; zero along other axes. Beside it
/// its moment about the point `about`.
pub fn reaction(
    mesh: &Mesh,
    (left, shared): (&[Vec3], &SharedNodes),
    surface: &str,
    (axes, about): ([bool; 3], Vec3),
) -> [Vec3; 2] {
    let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
    let Some(surface) = mesh.surface(surface).filter(|_| axes != [false; 3]) else {
        return [sum, moment];
    };
    for node in surface.nodes() {
        let left = left[node as usize];
        let own = [0, 1, 2].map(|axis| match axes[axis] {
            true => -left[axis] * shared.share(node, axis),
            false => 0.0,
        });
        let turn = cross(sub(mesh.points[node as usize], about), own);
        for axis in 0..3 {
            sum[axis] += own[axis];
            moment[axis] += turn[axis];
        }
    }
    [sum, moment]
}
