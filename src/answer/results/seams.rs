//! Edges at which faces meet, and how much the surface turns there.

use std::collections::BTreeMap;

use crate::ground::geometry::{cross, dot, norm, sub, unit};
use crate::model::mesh::{Face, Mesh};

/// Of each edge, its nodes ascending, the faces that have it, and which side of them it is.
pub struct Seams<'f> {
    faces: &'f [Face],
    sharing: BTreeMap<[u32; 2], Vec<(usize, usize)>>,
}

impl<'f> Seams<'f> {
    /// Those of some faces.
    pub fn of(faces: &'f [Face]) -> Self {
        let mut sharing: BTreeMap<[u32; 2], Vec<(usize, usize)>> = BTreeMap::new();
        for (index, face) in faces.iter().enumerate() {
            for side in 0..4 {
                let shared = sharing.entry(face.edge(side)).or_default();
                shared.push((index, side));
            }
        }
        Self { faces, sharing }
    }

    /// All edges, and the faces and sides at each.
    pub fn all(&self) -> impl Iterator<Item = ([u32; 2], &[(usize, usize)])> {
        let all = self.sharing.iter();
        all.map(|(nodes, shared)| (*nodes, shared.as_slice()))
    }

    /// The angle that the second of two faces at an edge is turned by from the first, in radians, outwards positive, and the
    /// distance of their middles; `None` where not two faces meet, or one has no area.
    pub fn turn(&self, mesh: &Mesh, nodes: [u32; 2]) -> Option<(f64, f64)> {
        let [(a, _), (b, _)] = self.sharing.get(&nodes)?.as_slice() else {
            return None;
        };
        let faces = [a, b].map(|face| &self.faces[*face]);
        let [m, n] = faces.map(|face| unit(face.area_vector(mesh)));
        let (m, n) = (m?, n?);
        let [from, to] = faces.map(|face| face.centre(mesh));
        let apart = sub(to, from);
        let angle = norm(cross(m, n)).atan2(dot(m, n));
        Some((angle.copysign(dot(sub(n, m), apart)), norm(apart)))
    }

    /// The same at the opposite side of a face.
    pub fn turn_opposite(&self, mesh: &Mesh, (face, side): (usize, usize)) -> Option<(f64, f64)> {
        self.turn(mesh, self.faces[face].edge(side + 2))
    }
}
