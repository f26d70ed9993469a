//! Is a hexahedron sound? Scaled Jacobians at its corners and determinants at its Gauss points.

use super::numbering::{EDGES, NEIGHBOURS};
use super::trilinear::gauss_volumes;
use crate::ground::geometry::{Vec3, cross, dot, norm, sub};

/// Below this, a scaled Jacobian counts as zero.
const ZERO_JACOBIAN: f64 = 1e-9;

/// How the corners of a hexahedron lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::model::mesh) enum Orientation {
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
pub(in crate::model::mesh) fn scaled_jacobians(x: &[[f64; 3]; 8]) -> [f64; 8] {
    std::array::from_fn(|corner| {
        let [a, b, c] = NEIGHBOURS[corner].map(|n| direction(sub(x[n], x[corner])));
        dot(cross(a, b), c)
    })
}

/// Lengths of the twelve edges.
pub(in crate::model::mesh) fn edge_lengths(x: &[[f64; 3]; 8]) -> [f64; 12] {
    EDGES.map(|[a, b]| norm(sub(x[b], x[a])))
}

/// Whether the element is sound, and what is wrong otherwise.
pub(in crate::model::mesh) fn orientation(x: &[[f64; 3]; 8]) -> Orientation {
    let corners = scaled_jacobians(x);
    let gauss = gauss_volumes(&unit_size(x));
    if corners.iter().all(|&j| j > ZERO_JACOBIAN) && gauss.iter().all(|&j| j > 0.0) {
        return Orientation::Sound;
    }
    if corners.iter().all(|&j| j < -ZERO_JACOBIAN) && gauss.iter().all(|&j| j < 0.0) {
        return Orientation::Mirrored;
    }
    // The comparison is false for NaN, so that an edge without length counts as flat.
    let clear = |j: f64| j.abs() > ZERO_JACOBIAN;
    let folded = corners.iter().all(|&j| clear(j))
        || (corners.iter().any(|&j| j > ZERO_JACOBIAN)
            && corners.iter().any(|&j| j < -ZERO_JACOBIAN));
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

/// The direction of `a`; not a number where it has none, so that such an edge is found out.
fn direction(a: Vec3) -> Vec3 {
    let length = norm(a);
    a.map(|c| c / length)
}

#[cfg(test)]
mod tests {
    use super::super::{CORNERS, mirrored, volume};
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
