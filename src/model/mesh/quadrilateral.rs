//! The bilinear quadrilateral: shape functions of a face of a hexahedron, of a facet of a surface.

/// Shape functions of the four corners at natural coordinates `s` in [-1, 1]²: each is one at its
/// own corner and zero at the others. The corners run counter-clockwise from (-1, -1).
#[inline]
pub fn shape(s: [f64; 2]) -> [f64; 4] {
    [
        0.25 * (1.0 - s[0]) * (1.0 - s[1]),
        0.25 * (1.0 + s[0]) * (1.0 - s[1]),
        0.25 * (1.0 + s[0]) * (1.0 + s[1]),
        0.25 * (1.0 - s[0]) * (1.0 + s[1]),
    ]
}

/// Derivatives of the shape functions by the two natural coordinates.
#[inline]
pub fn shape_derivatives(s: [f64; 2]) -> [[f64; 4]; 2] {
    let slopes = [
        [s[1] - 1.0, 1.0 - s[1], 1.0 + s[1], -1.0 - s[1]],
        [s[0] - 1.0, -1.0 - s[0], 1.0 + s[0], 1.0 - s[0]],
    ];
    slopes.map(|line| line.map(|slope| 0.25 * slope))
}

/// Natural coordinates of the corners.
pub const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_one_at_their_corner() {
        for (a, corner) in CORNERS.iter().enumerate() {
            for (b, value) in shape(*corner).iter().enumerate() {
                assert_eq!(*value, if a == b { 1.0 } else { 0.0 });
            }
        }
    }

    #[test]
    fn derivatives_are_the_slopes_of_the_shape_functions() {
        let (at, h) = ([0.3, -0.6], 1e-6);
        let derivatives = shape_derivatives(at);
        for axis in 0..2 {
            let mut moved = at;
            moved[axis] += h;
            let slopes = shape(moved).into_iter().zip(shape(at));
            for (slope, exact) in slopes.zip(derivatives[axis]) {
                assert!(((slope.0 - slope.1) / h - exact).abs() < 1e-9);
            }
        }
    }
}
