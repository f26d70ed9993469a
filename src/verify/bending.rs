//! Bending: the straight cantilever of MacNeal and Harder, and Cook's membrane.

use super::kit;
use super::{Claim, Extent, VerifyError};
use crate::material::Steel;
use crate::mesh::block::{Block, uniform};
use crate::scene::{Traction, TractionValue};

pub fn claims(_: Extent) -> Result<Vec<Claim>, VerifyError> {
    let mut claims = Vec::new();
    // (cells, expected shares of theory: extension, in plane, out of plane) for B-bar.
    let meshes = [
        ([6, 1, 1], [0.9947, 0.0996, 0.0257]),
        ([60, 4, 2], [0.9990, 0.9254, 0.7650]),
    ];
    for (cells, expected) in meshes {
        claims.extend(cantilever(cells, expected)?);
    }
    claims.push(cook()?);
    Ok(claims)
}

/// Length 6, depth 0.2 (y), thickness 0.1 (z), E = 1e7, ν = 0.3, clamped, unit force at the tip.
fn cantilever(cells: [usize; 3], expected: [f64; 3]) -> Result<Vec<Claim>, VerifyError> {
    let names = ["extension", "in plane", "out of plane"];
    let theory = [3.0e-5, 0.1081, 0.4321];
    let mut claims = Vec::new();
    for axis in 0..3 {
        let [x, y, z] = [6.0, 0.2, 0.1];
        let mesh = Block::new(
            "beam",
            uniform(0.0, x, cells[0]),
            uniform(0.0, y, cells[1]),
            uniform(0.0, z, cells[2]),
        )
        .build()?;
        let mut scene = kit::scene("cantilever", mesh, Steel::elastic(1e7, 0.3));
        scene.supports = vec![kit::support("x_min", [Some(0.0); 3])];
        let mut force = [0.0; 3];
        force[axis] = 1.0 / (y * z);
        scene.tractions = vec![Traction {
            name: "tip".into(),
            surface: "x_max".into(),
            value: TractionValue::Vector(force),
        }];
        let run = kit::run(scene)?;
        let tip = kit::mean_displacement(&run.scene.mesh, run.state(), "x_max")?[axis];
        let [n, m, l] = cells;
        let claim = Claim::relative(
            format!(
                "cantilever {n}x{m}x{l}, B-bar, {}: tip / theory",
                names[axis]
            ),
            tip / theory[axis],
            expected[axis],
            0.01,
        );
        claims.push(
            run.claim(
                claim
                    .from(
                        "MacNeal and Harder 1985; an independent B-bar hexahedron on the same mesh",
                    )
                    .because("the same element elsewhere; its reference is printed to four digits"),
            ),
        );
    }
    Ok(claims)
}

/// Cook's membrane in plane stress, as one thin layer free to contract.
fn cook() -> Result<Claim, VerifyError> {
    const CELLS: usize = 32;
    const THICKNESS: f64 = 0.5;
    let mesh = Block::new(
        "membrane",
        uniform(0.0, 1.0, CELLS),
        uniform(0.0, 1.0, CELLS),
        uniform(0.0, THICKNESS, 1),
    )
    .mapped(|[s, t, z]| [48.0 * s, 44.0 * s + t * (44.0 - 28.0 * s), z])
    .build()?;
    let mut scene = kit::scene("Cook", mesh, Steel::elastic(1.0, 1.0 / 3.0));
    scene.supports = vec![
        kit::support("x_min", [Some(0.0), Some(0.0), None]),
        kit::held("z_min", 2),
    ];
    scene.tractions = vec![Traction {
        name: "edge".into(),
        surface: "x_max".into(),
        value: TractionValue::Vector([0.0, 1.0 / 16.0, 0.0]),
    }];
    let run = kit::run(scene)?;
    let tip = kit::displacement_at(&run.scene.mesh, run.state(), [48.0, 52.0, 0.0])?[1];
    let claim = Claim::relative(
        "Cook's membrane, 32 x 32, B-bar: middle of the edge",
        tip,
        23.967,
        0.01,
    );
    Ok(run.claim(
        claim
            .from("Cook 1974; biquadratic elements, 64 x 64")
            .because("the bending error of B-bar falls with h²: 32 elements leave under 1 %"),
    ))
}
