//! Bending: the straight cantilever of MacNeal and Harder, and Cook's membrane.
//!
//! One element through a beam shows what an element is: B-bar is ten times too stiff, incompatible
//! modes bend exactly in a brick. Both fail in a trapezoid (MacNeal's limit for eight nodes). The
//! ratios come from separate programs; Brinell's enhanced element fits its volumetric modes so that
//! it cannot lock in volume, and is up to 0.5 % softer than the published one, which does not.

use crate::model::material::Steel;
use crate::model::mesh::Mesh;
use crate::model::mesh::block::{Block, uniform};
use crate::model::scene::{ElementKind, Scene};
use crate::proof::closed_forms::patch::{CANTILEVER, COOK_MIDDLE};
use crate::proof::verify::kit::{self, NamedElement};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// Length, depth (y) and thickness (z) of the cantilever.
const BEAM: [f64; 3] = [6.0, 0.2, 0.1];

/// Which way the cross-sections between the elements lean.
#[derive(Debug, Clone, Copy, PartialEq)]
enum BeamCells {
    Regular,
    Trapezoidal,
    Parallelogram,
}

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    use BeamCells::{Parallelogram, Regular, Trapezoidal};
    const BBAR: &str =
        "MacNeal and Harder 1985; B-bar hexahedra (own program, no version, no deck)";
    const MODES: &str = "MacNeal and Harder 1985; HEX8 of Altair OptiStruct, verification problem OS-V:0720 (version not stated)";
    const FINE_MODES: &str =
        "MacNeal and Harder 1985; incompatible modes of Taylor (own program, no version, no deck)";
    let [bbar, enhanced] = kit::ELEMENTS;
    let (coarse, fine) = ([6, 1, 1], [60, 4, 2]);
    // Shares of theory: extension, in plane, out of plane.
    let beams = [
        (bbar, BBAR, coarse, Regular, [0.9947, 0.0996, 0.0257]),
        (bbar, BBAR, fine, Regular, [0.9990, 0.9254, 0.7650]),
        (bbar, BBAR, coarse, Trapezoidal, [0.9956, 0.0290, 0.0106]),
        (bbar, BBAR, coarse, Parallelogram, [0.9955, 0.0473, 0.0144]),
        (enhanced, MODES, coarse, Regular, [0.9876, 0.9782, 0.9729]),
        (
            enhanced,
            FINE_MODES,
            fine,
            Regular,
            [0.9985, 0.9960, 0.9956],
        ),
        (
            enhanced,
            MODES,
            coarse,
            Trapezoidal,
            [0.9943, 0.0473, 0.0302],
        ),
        (
            enhanced,
            MODES,
            coarse,
            Parallelogram,
            [0.9942, 0.6236, 0.5283],
        ),
    ];
    let mut claims = Vec::new();
    for (kind, source, cells, shape, expected) in beams {
        for claim in cantilever(kind, cells, shape, expected)? {
            claims.push(claim.from(source).because(
                "the element elsewhere, to four digits; the fit of the volumetric modes is 0.5 %",
            ));
        }
    }
    for kind in kit::ELEMENTS {
        claims.push(plane_stress(kind)?);
        claims.push(plane_strain(kind)?);
    }
    Ok(claims)
}

fn beam(cells: [usize; 3], shape: BeamCells) -> Result<Mesh, VerifyError> {
    let [x, y, z] = [0, 1, 2].map(|i| uniform(0.0, BEAM[i], cells[i]));
    // 45° at the cross-sections within.
    let lean = |[x, y, z]: [f64; 3]| {
        let offset = y - 0.5 * BEAM[1];
        let inside = x > 0.5 && x < BEAM[0] - 0.5;
        let shift = match shape {
            BeamCells::Parallelogram if inside => offset,
            BeamCells::Trapezoidal if inside => offset * (-1f64).powi(1 + x.round() as i32),
            _ => 0.0,
        };
        [x + shift, y, z]
    };
    Ok(Block::new("beam", x, y, z).mapped(lean).build()?)
}

/// E = 1e7, ν = 0.3, clamped, unit force at the tip along each axis in turn.
fn cantilever(
    (kind, name): NamedElement,
    cells: [usize; 3],
    shape: BeamCells,
    expected: [f64; 3],
) -> Result<Vec<LadderClaim>, VerifyError> {
    let names = ["extension", "in plane", "out of plane"];
    let theory = [
        CANTILEVER.extension,
        CANTILEVER.in_plane,
        CANTILEVER.out_of_plane,
    ];
    let [n, m, l] = cells;
    let form = match shape {
        BeamCells::Regular => "",
        BeamCells::Trapezoidal => " trapezoids",
        BeamCells::Parallelogram => " parallelograms",
    };
    let mut claims = Vec::new();
    for axis in 0..3 {
        let mut scene = Scene::bare("cantilever", beam(cells, shape)?, Steel::elastic(1e7, 0.3));
        scene.controls.element = kind;
        // Slender: forces are small beside stiffness times displacement.
        scene.controls.residual = 1e-7;
        scene.supports = vec![kit::support("x_min", [Some(0.0); 3])];
        let mut force = [0.0; 3];
        force[axis] = 1.0 / (BEAM[1] * BEAM[2]);
        scene.tractions = vec![kit::traction("tip", "x_max", force)];
        let run = kit::run(scene)?;
        let tip = kit::mean_displacement(&run.scene.mesh, run.state(), "x_max")?[axis];
        claims.push(run.claim(LadderClaim::relative(
            format!("cantilever {n}x{m}x{l}{form}, {name}, {}", names[axis]),
            tip / theory[axis],
            expected[axis],
            0.01,
        )));
    }
    Ok(claims)
}

const CELLS: usize = 32;

/// Cook's membrane, `thickness` thick, under the shear `force` on its right edge.
fn membrane(
    kind: ElementKind,
    thickness: f64,
    force: f64,
) -> Result<crate::model::scene::Scene, VerifyError> {
    let list = || uniform(0.0, 1.0, CELLS);
    let mesh = Block::new("membrane", list(), list(), vec![0.0, thickness])
        .mapped(|[s, t, z]| [48.0 * s, 44.0 * s + t * (44.0 - 28.0 * s), z])
        .build()?;
    let mut scene = Scene::bare("Cook", mesh, Steel::elastic(1.0, 1.0 / 3.0));
    scene.controls.element = kind;
    scene.controls.residual = 1e-7;
    scene.supports = vec![
        kit::support("x_min", [Some(0.0), Some(0.0), None]),
        kit::held("z_min", 2),
    ];
    let up = [0.0, force / 16.0, 0.0];
    scene.tractions = vec![kit::traction("edge", "x_max", up)];
    Ok(scene)
}

/// In plane stress, as one thin layer free to contract.
fn plane_stress((kind, name): NamedElement) -> Result<LadderClaim, VerifyError> {
    let run = kit::run(membrane(kind, 0.5, 1.0)?)?;
    let tip = kit::displacement_at(&run.scene.mesh, run.state(), [48.0, 52.0, 0.0])?[1];
    let claim = format!("Cook's membrane, {CELLS} x {CELLS}, {name}: middle of the edge");
    Ok(run.claim(
        LadderClaim::relative(claim, tip, COOK_MIDDLE, 0.01)
            .from("Cook 1974; biquadratic elements, 64 x 64 (own program, no version, no deck)")
            .because("the bending error of B-bar falls with h²: 32 elements leave under 1 %"),
    ))
}

/// In plane strain, hardly compressible.
fn plane_strain((kind, name): NamedElement) -> Result<LadderClaim, VerifyError> {
    let mut scene = membrane(kind, 1.0, 100.0)?;
    scene.materials = vec![Steel::elastic(240.565, 0.4999)];
    scene.supports.push(kit::held("z_max", 2));
    let run = kit::run(scene)?;
    let tip = kit::displacement_at(&run.scene.mesh, run.state(), [48.0, 52.0, 0.0])?[1];
    let claim = format!("the same, plane strain, ν = 0.4999, {name}");
    Ok(run.claim(
        LadderClaim::relative(claim, tip, 7.69, 0.015)
            .from("biquadratic elements, extrapolated (own program, no version, no deck)")
            .because("the reference is good to 1 %, 32 elements to 0.5 %"),
    ))
}
