//! The programs in `examples/`: their figures stand beside the closed forms as closely as mesh and theory allow.

mod page;

use std::error::Error;

#[allow(dead_code)]
#[path = "../../examples/bearing.rs"]
mod bearing;
#[allow(dead_code)]
#[path = "../../examples/friction.rs"]
mod friction;
#[allow(dead_code)]
#[path = "../../examples/hertz_line.rs"]
mod hertz_line;
#[allow(dead_code)]
#[path = "../../examples/own_mesh.rs"]
mod own_mesh;
#[allow(dead_code)]
#[path = "../../examples/own_steel.rs"]
mod own_steel;
#[allow(dead_code)]
#[path = "../../examples/rigid_plane.rs"]
mod rigid_plane;
#[allow(dead_code)]
#[path = "../../examples/sphere_on_block.rs"]
mod sphere_on_block;
#[allow(dead_code)]
#[path = "../../examples/sweep.rs"]
mod sweep;
#[allow(dead_code)]
#[path = "../../examples/two_materials.rs"]
mod two_materials;
#[allow(dead_code)]
#[path = "../../examples/yield_and_unload.rs"]
mod yield_and_unload;

type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

/// Each figure is off by no more than its tolerance, as a share of the exact value, and as its page says.
fn check(name: &str, figures: Figures, tolerances: &[f64]) {
    let figures = figures.expect("the example runs");
    assert_eq!(figures.len(), tolerances.len());
    page::check(name, &figures);
    for ((what, value, exact), tolerance) in figures.into_iter().zip(tolerances) {
        let off = (value / exact - 1.0).abs();
        assert!(
            off <= *tolerance,
            "{what}: {value} for {exact}, {off:.1e} off"
        );
    }
}

/// h/a = 1/8: pressure and width are of second order in h, the bodies change them by 0.2 % and the Mises stress in the
/// block by 2 %; a nodal Mises stress is off by some (h/a)².
#[test]
fn hertz_line() {
    check("hertz_line", hertz_line::figures(), &[0.005, 0.01, 0.03]);
}

/// The force follows from balance; h/a = 1/5 in two directions, of which a hat function at the peak sees a sixth of
/// (h/a)²; the radius by the second moment sees the rim.
#[test]
fn sphere_on_block() {
    check(
        "sphere_on_block",
        sphere_on_block::figures(),
        &[1e-5, 0.015, 0.015],
    );
}

/// As [`hertz_line`] at h/a = 1/10; a block of eight radii is a half space to within 0.3 %.
#[test]
fn two_materials() {
    check(
        "two_materials",
        two_materials::figures(),
        &[0.005, 0.01, 0.02, 0.01],
    );
}

/// The force Q by balance; the sticking strip ends between two nodes, a quarter of h/c with h/c = 1/8.5.
#[test]
fn friction() {
    check("friction", friction::figures(), &[0.005, 1e-4, 0.03]);
}

/// Twenty layers: (h/a)² / 2 is 1.3e-3, and ν = 0.4999 for 0.5 is 5e-5; what stays is a difference of two
/// displacements.
#[test]
fn yield_and_unload() {
    check(
        "yield_and_unload",
        yield_and_unload::figures(),
        &[0.003, 0.01],
    );
}

/// The force by balance; the formula is 0.04 to 0.7 % below the exact series for a/R of 0.01 to 0.2.
#[test]
fn rigid_plane() {
    check("rigid_plane", rigid_plane::figures(), &[1e-6, 0.005, 0.005]);
}

/// The file has few elements across the strip; the line load does not mind.
#[test]
fn own_mesh() {
    check("own_mesh", own_mesh::figures(), &[0.05, 0.05, 0.005]);
}

/// Radial return is exact in proportional loading; the residual remains.
#[test]
fn own_steel() {
    check("own_steel", own_steel::figures(), &[1e-6, 1e-6, 1e-6]);
}

/// Forces by balance; friction changes the load in the valley by 1 %, and the roller, which bends, bears more in its
/// middle than spread evenly.
#[test]
fn bearing() {
    check("bearing", bearing::figures(), &[1e-5, 1e-5, 0.02, 0.08]);
}

/// h/a = 1/6, as [`hertz_line`].
#[test]
fn sweep() {
    check("sweep", sweep::figures(), &[0.01; 4]);
}
