//! Vectors, points and stresses under the half turn.

use crate::ground::geometry::Vec3;

/// A vector, turned.
pub fn turned([x, y, z]: Vec3) -> Vec3 {
    [y, x, -z]
}

/// A point, turned about the axis at the height `middle`.
pub fn turned_point([x, y, z]: Vec3, middle: f64) -> Vec3 {
    [y, x, 2.0 * middle - z]
}

/// A stress xx yy zz xy yz zx, turned.
pub fn turned_stress([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> [f64; 6] {
    [yy, xx, zz, xy, -zx, -yz]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stress_turns_as_its_traction_and_its_normal_do() {
        let stress = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let traction = |s: [f64; 6], n: Vec3| {
            let [xx, yy, zz, xy, yz, zx] = s;
            [
                xx * n[0] + xy * n[1] + zx * n[2],
                xy * n[0] + yy * n[1] + yz * n[2],
                zx * n[0] + yz * n[1] + zz * n[2],
            ]
        };
        let normal = [0.3, -0.5, 0.7];
        let turned_traction = traction(turned_stress(stress), turned(normal));
        assert_eq!(turned_traction, turned(traction(stress, normal)));
        assert_eq!(turned(turned(normal)), normal);
        assert_eq!(turned_stress(turned_stress(stress)), stress);
    }
}
