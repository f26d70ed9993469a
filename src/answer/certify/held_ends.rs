//! What a mesh does not see at the ends of bodies that are held.
//!
//! A held end keeps the section from contracting. The stress along the end that this makes falls off within a width of the section. An
//! element that is longer carries it to its other side, and nodal averages have nothing to set against it: beyond the end there is no
//! element.

use super::strain_energy::density;
use crate::answer::results::outer_faces::{Bound, OuterFaces};
use crate::answer::results::recovery::Recovered;
use crate::ground::geometry::{Vec3, dot, scale, sub, unit};
use crate::model::material::matrix;
use crate::model::mesh::hexahedron::{NEIGHBOURS, faces_of};
use crate::model::mesh::surface::sorted;
use crate::model::scene::Scene;
use crate::model::state::State;
use std::collections::BTreeMap;

/// The element at a held face.
struct HeldEnd {
    element: usize,
    /// Unit normal of the face.
    normal: Vec3,
    columns: [Column; 4],
}

/// Two integration points of an element, one behind the other as seen from a face.
struct Column {
    /// The node behind.
    behind: u32,
    /// Mean stress, and volume.
    stress: [f64; 6],
    volume: f64,
}

/// Of the stresses along held ends, twice the strain energy of what they differ by from those in the elements next to them.
pub(super) fn unseen_energy(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    outer: &OuterFaces,
) -> f64 {
    let mesh = &scene.mesh;
    let columns = |element: usize, face: [u32; 4]| {
        let (stress, volumes) = (&state.stress[element], &recovered.volumes[element]);
        Column::behind(&mesh.hexes[element], face, (stress, volumes))
    };
    let mut sum = 0.0;
    for ((body, faces), steel) in mesh.bodies.iter().zip(&outer.by_body).zip(&scene.materials) {
        let mut ends: BTreeMap<[u32; 4], HeldEnd> = BTreeMap::new();
        for face in faces.iter().filter(|face| outer.bound(face) == Bound::Held) {
            let Some(normal) = unit(face.area_vector(mesh)) else {
                continue;
            };
            let element = face.element as usize;
            let columns = columns(element, face.nodes);
            let behind = sorted(columns.each_ref().map(|column| column.behind));
            let end = HeldEnd {
                element,
                normal,
                columns,
            };
            ends.insert(behind, end);
        }
        if ends.is_empty() {
            continue;
        }
        let mut is_behind = vec![false; mesh.points.len()];
        for node in ends.keys().flatten() {
            is_behind[*node as usize] = true;
        }
        let is_next = |element: &usize| mesh.hexes[*element].iter().any(|n| is_behind[*n as usize]);
        for element in body.elements.clone().filter(is_next) {
            for face in faces_of(&mesh.hexes[element]) {
                let end = ends.get(&sorted(face)).filter(|end| end.element != element);
                let Some(end) = end else {
                    continue;
                };
                for (next, node) in columns(element, face).iter().zip(face) {
                    let own = end.columns.iter().find(|column| column.behind == node);
                    sum += own.map_or(0.0, |own| {
                        let by = std::array::from_fn(|k| own.stress[k] - next.stress[k]);
                        density(&along(&by, end.normal), steel) * own.volume
                    });
                }
            }
        }
    }
    sum
}

impl Column {
    /// Those that go inwards from the corners of a face of a hexahedron.
    fn behind(
        hex: &[u32; 8],
        face: [u32; 4],
        (stress, volumes): (&[[f64; 6]; 8], &[f64; 8]),
    ) -> [Self; 4] {
        face.map(|node| {
            let at = hex.iter().position(|n| *n == node).unwrap_or_default();
            let mut beside = NEIGHBOURS[at].into_iter();
            let behind = beside.find(|k| !face.contains(&hex[*k])).unwrap_or(at);
            Self {
                behind: hex[behind],
                stress: std::array::from_fn(|k| 0.5 * (stress[at][k] + stress[behind][k])),
                volume: volumes[at] + volumes[behind],
            }
        })
    }
}

/// The part of a stress that acts along planes with this normal, on planes square to them: P σ P with P = I − n n^T.
fn along(stress: &[f64; 6], normal: Vec3) -> [f64; 6] {
    let square = |v: Vec3| sub(v, scale(normal, dot(normal, v)));
    let rows = matrix(*stress).map(square);
    let column = |j: usize| square([0, 1, 2].map(|i| rows[i][j]));
    let [x, y, z] = [0, 1, 2].map(column);
    [x[0], y[1], z[2], x[1], y[2], z[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn across_a_plane_nothing_is_left() {
        let stress = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        assert_eq!(
            along(&stress, [0.0, 0.0, 1.0]),
            [1.0, 2.0, 0.0, 4.0, 0.0, 0.0]
        );
    }
}
