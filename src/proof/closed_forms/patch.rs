//! Constants of the element tests: the solid patch, the straight cantilever, Cook's membrane.

/// Inner nodes of the distorted patch of hexahedra in the unit cube.
///
/// MacNeal and Harder, *A proposed standard set of problems to test finite element accuracy*,
/// Finite Elements in Analysis and Design 1 (1985) 3. The first four lie below, the last four
/// above, each four counter-clockwise; seven hexahedra join them to the cube's corners.
pub const INNER_NODES: [[f64; 3]; 8] = [
    [0.249, 0.342, 0.192],
    [0.826, 0.288, 0.288],
    [0.850, 0.649, 0.263],
    [0.273, 0.750, 0.230],
    [0.320, 0.186, 0.643],
    [0.677, 0.305, 0.683],
    [0.788, 0.693, 0.644],
    [0.165, 0.745, 0.702],
];

/// Young's modulus of the patch.
pub const YOUNGS_MODULUS: f64 = 1e6;
/// Poisson's ratio of the patch.
pub const POISSONS_RATIO: f64 = 0.25;
/// Every component of strain in the patch; shear as engineering strain.
pub const STRAIN: f64 = 1e-3;

/// Stress everywhere in the patch: normal components 2000, shear components 400.
pub fn stress() -> crate::analytic::Stress {
    let (lame, shear) = (4e5, 4e5);
    let normal = 3.0 * lame * STRAIN + 2.0 * shear * STRAIN;
    let tangential = shear * STRAIN;
    crate::analytic::Stress {
        xx: normal,
        yy: normal,
        zz: normal,
        xy: tangential,
        yz: tangential,
        zx: tangential,
    }
}

/// Straight cantilever of MacNeal and Harder: length 6, depth 0.2, thickness 0.1, E = 10⁷,
/// ν = 0.3, unit load at the tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cantilever {
    /// Displacement along a unit axial force.
    pub extension: f64,
    /// Deflection along a unit force in the plane of the depth.
    pub in_plane: f64,
    /// Deflection along a unit force in the plane of the thickness.
    pub out_of_plane: f64,
    /// Rotation about the axis under a unit torque.
    pub twist: f64,
}

/// Their theoretical tip displacements, table 3.
pub const CANTILEVER: Cantilever = Cantilever {
    extension: 3.0e-5,
    in_plane: 0.1081,
    out_of_plane: 0.4321,
    twist: 0.03208,
};

/// Vertical displacement at the middle of the right edge, (48, 52), of Cook's membrane: a panel
/// with corners (0, 0), (48, 44), (48, 60), (0, 44), E = 1, ν = 1/3, thickness 1, plane stress,
/// clamped left, an even upward shear of total 1 on the right. Converged with biquadratic
/// elements.
pub const COOK_MIDDLE: f64 = 23.967;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stress_of_the_patch() {
        let stress = stress();
        for normal in [stress.xx, stress.yy, stress.zz] {
            assert!((normal - 2000.0).abs() < 1e-9);
        }
        for shear in [stress.xy, stress.yz, stress.zx] {
            assert!((shear - 400.0).abs() < 1e-9);
        }
    }

    #[test]
    fn cantilever_is_the_beam_with_shear() {
        // P L/EA and P L³/3EI + 1.2 P L/GA.
        let (length, area, e, shear) = (6.0, 0.02, 1e7, 1e7 / 2.6);
        assert!((CANTILEVER.extension - length / (e * area)).abs() < 1e-15);
        let deflection = |depth: f64| {
            4.0 * f64::powi(length, 3) / (e * area * depth * depth) + 1.2 * length / (shear * area)
        };
        assert!((CANTILEVER.in_plane / deflection(0.2) - 1.0).abs() < 1e-3);
        assert!((CANTILEVER.out_of_plane / deflection(0.1) - 1.0).abs() < 1e-3);
    }
}
