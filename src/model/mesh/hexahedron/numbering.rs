//! How the corners, edges and faces of a hexahedron are numbered.

/// Natural coordinates of the corners, in the node order of [`crate::model::mesh::Mesh`].
pub const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// The twelve edges, as pairs of corners.
pub const EDGES: [[usize; 2]; 12] = [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
    [4, 5],
    [5, 6],
    [6, 7],
    [7, 4],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
];

/// Corners of the six faces, counter-clockwise seen from outside.
pub const FACES: [[usize; 4]; 6] = [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 1, 5, 4],
    [1, 2, 6, 5],
    [2, 3, 7, 6],
    [3, 0, 4, 7],
];

/// The three neighbours of each corner, ordered so that a sound element has positive triple
/// products of the edges towards them.
pub const NEIGHBOURS: [[usize; 3]; 8] = [
    [1, 3, 4],
    [2, 0, 5],
    [3, 1, 6],
    [0, 2, 7],
    [7, 5, 0],
    [4, 6, 1],
    [5, 7, 2],
    [6, 4, 3],
];

/// The six faces by node index, counter-clockwise seen from outside.
pub fn faces_of(hex: &[u32; 8]) -> [[u32; 4]; 6] {
    FACES.map(|face| face.map(|corner| hex[corner]))
}

/// The same element numbered for the mirror image.
pub fn mirrored(nodes: [u32; 8]) -> [u32; 8] {
    let [a, b, c, d, e, f, g, h] = nodes;
    [e, f, g, h, a, b, c, d]
}

/// Corners of the side of `hex` that `face` is, the axis that it is across, and at which end of that it is.
pub fn side_of(hex: &[u32; 8], face: &[u32; 4]) -> Option<([usize; 4], usize, f64)> {
    let corners = FACES.into_iter().find(|side| {
        let nodes = side.map(|c| hex[c]);
        nodes.iter().all(|node| face.contains(node))
    })?;
    let at = corners.map(|c| CORNERS[c]);
    let axis = (0..3).find(|k| at.iter().all(|p| p[*k] == at[0][*k]))?;
    Some((corners, axis, at[0][axis]))
}
