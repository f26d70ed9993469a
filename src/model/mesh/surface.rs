//! Faces of hexahedra: which are outer, which element a quadrilateral belongs to, which way is out.

pub use super::hexahedron::{FACES, faces_of};
use super::quadrilateral::area_vector;
use super::{Face, Mesh};
use crate::ground::geometry::{norm, sub};
use std::collections::{BTreeMap, HashMap};

/// What a quadrilateral is to the hexahedra.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FaceMatch {
    /// It is the face of no hexahedron.
    None,
    /// It is a face of exactly one hexahedron; here it is, turned outward.
    Outer(Face),
    /// It lies between these two hexahedra.
    Between(u32, u32),
}

/// Finds the hexahedra that quadrilaterals belong to.
pub(super) struct FaceFinder<'a> {
    hexes: &'a [[u32; 8]],
    /// The elements around node `n` are `around[start[n]..start[n + 1]]`.
    start: Vec<usize>,
    around: Vec<u32>,
}

impl<'a> FaceFinder<'a> {
    /// A finder for `hexes`, whose node indices are all below `nodes`.
    pub fn new(hexes: &'a [[u32; 8]], nodes: usize) -> Self {
        let mut start = vec![0usize; nodes + 1];
        for &node in hexes.iter().flatten() {
            start[node as usize + 1] += 1;
        }
        for n in 0..nodes {
            start[n + 1] += start[n];
        }
        let mut next = start.clone();
        let mut around = vec![0u32; hexes.len() * 8];
        for (element, hex) in (0u32..).zip(hexes) {
            for &node in hex {
                around[next[node as usize]] = element;
                next[node as usize] += 1;
            }
        }
        Self {
            hexes,
            start,
            around,
        }
    }

    /// Elements that use node `node`.
    pub fn around(&self, node: u32) -> &[u32] {
        let node = node as usize;
        match (self.start.get(node), self.start.get(node + 1)) {
            (Some(&from), Some(&to)) => &self.around[from..to],
            _ => &[],
        }
    }

    /// The hexahedron that has the four nodes of `quad`, in whatever order, as one of its faces.
    pub fn find(&self, quad: [u32; 4]) -> FaceMatch {
        let wanted = sorted(quad);
        let mut found: Option<Face> = None;
        for &element in self.around(quad[0]) {
            for nodes in faces_of(&self.hexes[element as usize]) {
                if sorted(nodes) != wanted {
                    continue;
                }
                match found {
                    None => found = Some(Face { nodes, element }),
                    Some(first) => return FaceMatch::Between(first.element, element),
                }
            }
        }
        found.map_or(FaceMatch::None, FaceMatch::Outer)
    }
}

impl Mesh {
    /// Takes away whole faces and the pieces that lie on them from the other side.
    fn without_steps(&self, once: &mut BTreeMap<[u32; 4], usize>, faces: &[Face]) {
        let hanging = self.hanging.iter();
        let middle: HashMap<&[u32], u32> =
            hanging.map(|h| (h.corners.as_slice(), h.node)).collect();
        let of = |nodes: &[u32]| {
            let mut key = nodes.to_vec();
            key.sort_unstable();
            middle.get(key.as_slice()).copied()
        };
        let mut gone: Vec<[u32; 4]> = Vec::new();
        for (key, index) in once.iter() {
            let [a, b, c, d] = faces[*index].nodes;
            let ends = [[a, b], [b, c], [c, d], [d, a]];
            let pieces = match (ends.map(|ends| of(&ends)), of(key)) {
                ([Some(ab), Some(bc), Some(cd), Some(da)], Some(m)) => {
                    vec![
                        [a, ab, m, da],
                        [b, bc, m, ab],
                        [c, cd, m, bc],
                        [d, da, m, cd],
                    ]
                }
                ([Some(ab), _, Some(cd), _], None)
                    if once.contains_key(&sorted([a, ab, cd, d])) =>
                {
                    vec![[a, ab, cd, d], [ab, b, c, cd]]
                }
                ([_, Some(bc), _, Some(da)], None) => vec![[a, b, bc, da], [da, bc, c, d]],
                _ => continue,
            };
            let pieces: Vec<[u32; 4]> = pieces.into_iter().map(sorted).collect();
            if pieces.iter().all(|piece| once.contains_key(piece)) {
                gone.push(*key);
                gone.extend(pieces);
            }
        }
        for key in gone {
            once.remove(&key);
        }
    }

    /// The faces of body `body` that only one of its elements has, in the order of the elements.
    pub fn outer_faces(&self, body: usize) -> Vec<Face> {
        let elements = self.bodies[body].elements.clone();
        let first = elements.start;
        let faces: Vec<Face> = (first as u32..)
            .zip(&self.hexes[elements])
            .flat_map(|(element, hex)| faces_of(hex).map(|nodes| Face { nodes, element }))
            .collect();
        let mut keys: Vec<([u32; 4], usize)> = faces
            .iter()
            .enumerate()
            .map(|(k, face)| (sorted(face.nodes), k))
            .collect();
        keys.sort_unstable();
        let once = keys
            .chunk_by(|a, b| a.0 == b.0)
            .filter(|c| c.len() == 1)
            .map(|c| c[0]);
        let mut once: BTreeMap<[u32; 4], usize> = once.collect();
        if !self.hanging.is_empty() {
            self.without_steps(&mut once, &faces);
        }
        let mut outer: Vec<usize> = once.into_values().collect();
        outer.sort_unstable();
        outer.into_iter().map(|k| faces[k]).collect()
    }
}

impl Face {
    /// Coordinates of its nodes.
    pub fn corners(&self, mesh: &Mesh) -> [[f64; 3]; 4] {
        self.nodes.map(|n| mesh.points[n as usize])
    }

    /// Outward normal times area, exact for the bilinear face.
    pub fn area_vector(&self, mesh: &Mesh) -> [f64; 3] {
        area_vector(&self.corners(mesh))
    }

    /// Lengths of its four sides.
    pub fn sides(&self, mesh: &Mesh) -> [f64; 4] {
        let corners = self.corners(mesh);
        [0, 1, 2, 3].map(|k| norm(sub(corners[k], corners[(k + 1) % 4])))
    }

    /// The nodes at the ends of a side, ascending.
    pub fn edge(&self, side: usize) -> [u32; 2] {
        sorted([self.nodes[side % 4], self.nodes[(side + 1) % 4]])
    }

    /// Its element and its nodes, ascending: what tells it from other faces however it is seen.
    pub fn key(&self) -> (u32, [u32; 4]) {
        (self.element, sorted(self.nodes))
    }

    /// Mean of its nodes.
    pub fn centre(&self, mesh: &Mesh) -> [f64; 3] {
        let x = self.corners(mesh);
        [0, 1, 2].map(|k| 0.25 * (x[0][k] + x[1][k] + x[2][k] + x[3][k]))
    }
}

/// Nodes of an edge or a face in ascending order: the same from whichever element it is seen.
pub fn sorted<const N: usize>(mut nodes: [u32; N]) -> [u32; N] {
    nodes.sort_unstable();
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::mesh::hexahedron::CORNERS;

    #[test]
    fn face_normals_point_outward() {
        let mesh = Mesh {
            points: CORNERS.to_vec(),
            hexes: vec![[0, 1, 2, 3, 4, 5, 6, 7]],
            ..Mesh::default()
        };
        for nodes in faces_of(&mesh.hexes[0]) {
            let face = Face { nodes, element: 0 };
            let (centre, area) = (face.centre(&mesh), face.area_vector(&mesh));
            for k in 0..3 {
                assert!((area[k] - 4.0 * centre[k]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_shared_face_lies_between_and_an_outer_one_is_turned_outward() {
        let hexes = [[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]];
        let finder = FaceFinder::new(&hexes, 12);
        assert_eq!(finder.find([7, 6, 5, 4]), FaceMatch::Between(0, 1));
        assert_eq!(
            finder.find([0, 1, 2, 3]),
            FaceMatch::Outer(Face {
                nodes: [0, 3, 2, 1],
                element: 0
            })
        );
        assert_eq!(finder.find([0, 1, 2, 8]), FaceMatch::None);
        assert_eq!(finder.find([99, 1, 2, 8]), FaceMatch::None);
    }
}
