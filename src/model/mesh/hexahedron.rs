//! Geometry of one eight-node hexahedron: Jacobians, orientation, volume.

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

/// The three neighbours of each corner, ordered so that a sound element has positive triple
/// products of the edges towards them.
const NEIGHBOURS: [[usize; 3]; 8] = [
    [1, 3, 4],
    [2, 0, 5],
    [3, 1, 6],
    [0, 2, 7],
    [7, 5, 0],
    [4, 6, 1],
    [5, 7, 2],
    [6, 4, 3],
];

/// Below this, a scaled Jacobian counts as zero.
const FLAT: f64 = 1e-9;

/// How the corners of a hexahedron lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Orientation {
    /// The Jacobian is positive at every corner and integration point.
    Sound,
    /// The Jacobian is negative everywhere: the nodes are numbered for the mirror image.
    Mirrored,
    /// The Jacobian changes its sign: the element is folded. The corner with the smallest scaled
    /// Jacobian (which may be positive, where only an integration point is inverted), and its value.
    Inverted { corner: usize, jacobian: f64 },
    /// The Jacobian vanishes at this corner.
    Flat { corner: usize, jacobian: f64 },
}

/// Scaled Jacobian at each corner: the triple product of the unit vectors along its edges, from
/// -1 to 1; 1 for a box. Not a number where an edge has no length.
pub fn scaled_jacobians(x: &[[f64; 3]; 8]) -> [f64; 8] {
    std::array::from_fn(|corner| {
        let [a, b, c] = NEIGHBOURS[corner].map(|n| unit(sub(x[n], x[corner])));
        dot(cross(a, b), c)
    })
}

/// Determinants of the Jacobian at the 2 x 2 x 2 Gauss points, in the order of the corners.
pub fn gauss_jacobians(x: &[[f64; 3]; 8]) -> [f64; 8] {
    let reach = 1.0 / 3f64.sqrt();
    CORNERS.map(|corner| jacobian(x, corner.map(|c| c * reach)))
}

/// Determinant of the Jacobian at natural coordinates `at`.
pub fn jacobian(x: &[[f64; 3]; 8], at: [f64; 3]) -> f64 {
    let mut columns = [[0.0; 3]; 3];
    for (point, c) in x.iter().zip(&CORNERS) {
        let [u, v, w] = [0, 1, 2].map(|k| 1.0 + c[k] * at[k]);
        let slopes = [c[0] * v * w, c[1] * u * w, c[2] * u * v];
        for (column, slope) in columns.iter_mut().zip(slopes) {
            for (sum, coordinate) in column.iter_mut().zip(point) {
                *sum += 0.125 * slope * coordinate;
            }
        }
    }
    dot(cross(columns[0], columns[1]), columns[2])
}

/// Volume, exact for the trilinear element; negative for a mirrored one.
pub fn volume(x: &[[f64; 3]; 8]) -> f64 {
    gauss_jacobians(x).iter().sum()
}

/// Lengths of the twelve edges.
pub fn edge_lengths(x: &[[f64; 3]; 8]) -> [f64; 12] {
    EDGES.map(|[a, b]| norm(sub(x[b], x[a])))
}

/// Whether the element is sound, and what is wrong otherwise.
pub fn orientation(x: &[[f64; 3]; 8]) -> Orientation {
    let corners = scaled_jacobians(x);
    let gauss = gauss_jacobians(&unit_size(x));
    if corners.iter().all(|&j| j > FLAT) && gauss.iter().all(|&j| j > 0.0) {
        return Orientation::Sound;
    }
    if corners.iter().all(|&j| j < -FLAT) && gauss.iter().all(|&j| j < 0.0) {
        return Orientation::Mirrored;
    }
    // The comparison is false for NaN, so that an edge without length counts as flat.
    let clear = |j: f64| j.abs() > FLAT;
    let folded = corners.iter().all(|&j| clear(j))
        || (corners.iter().any(|&j| j > FLAT) && corners.iter().any(|&j| j < -FLAT));
    let rank = |j: f64| if folded { j } else { j.abs() };
    let mut worst = 0;
    for (corner, &j) in corners.iter().enumerate() {
        if j.is_nan() && !folded {
            return Orientation::Flat {
                corner,
                jacobian: 0.0,
            };
        }
        if rank(j) < rank(corners[worst]) {
            worst = corner;
        }
    }
    let jacobian = corners[worst];
    if folded {
        Orientation::Inverted {
            corner: worst,
            jacobian,
        }
    } else {
        Orientation::Flat {
            corner: worst,
            jacobian,
        }
    }
}

/// The same element numbered for the mirror image.
pub fn mirrored(nodes: [u32; 8]) -> [u32; 8] {
    let [a, b, c, d, e, f, g, h] = nodes;
    [e, f, g, h, a, b, c, d]
}

/// The element moved to the origin and scaled to unit size, against overflow and underflow.
fn unit_size(x: &[[f64; 3]; 8]) -> [[f64; 3]; 8] {
    let shifted = x.map(|p| sub(p, x[0]));
    let size = shifted.iter().flatten().fold(0.0f64, |m, c| m.max(c.abs()));
    if size > 0.0 {
        shifted.map(|p| p.map(|c| c / size))
    } else {
        shifted
    }
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = norm(a);
    a.map(|c| c / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> [[f64; 3]; 8] {
        CORNERS
    }

    #[test]
    fn a_cube_has_unit_scaled_jacobians_and_its_volume() {
        assert_eq!(scaled_jacobians(&cube()), [1.0; 8]);
        assert!((volume(&cube()) - 8.0).abs() < 1e-14);
        assert_eq!(orientation(&cube()), Orientation::Sound);
    }

    #[test]
    fn mirrored_nodes_are_told_from_a_folded_element() {
        let mut x = cube();
        let order = mirrored([0, 1, 2, 3, 4, 5, 6, 7]);
        let turned = order.map(|n| cube()[n as usize]);
        assert_eq!(orientation(&turned), Orientation::Mirrored);
        x[6] = [-0.9, -0.9, -0.9];
        assert!(matches!(orientation(&x), Orientation::Inverted { .. }));
    }

    #[test]
    fn collapsed_corners_are_flat() {
        let mut x = cube();
        x[6] = x[5];
        assert!(matches!(orientation(&x), Orientation::Flat { .. }));
        let flat = cube().map(|p| [p[0], p[1], 0.0]);
        assert!(matches!(orientation(&flat), Orientation::Flat { .. }));
    }

    #[test]
    fn orientation_does_not_depend_on_the_length_unit() {
        for scale in [1e-150, 1e-12, 1e12, 1e100] {
            let x = cube().map(|p| p.map(|c| c * scale));
            assert_eq!(orientation(&x), Orientation::Sound, "{scale}");
        }
    }
}
