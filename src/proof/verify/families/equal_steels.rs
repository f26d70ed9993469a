//! Two identical half cylinders on mirrored meshes with friction under a normal load.
//!
//! Mirror images approach each other without sliding: there is no shear to find, whatever μ.

use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::scenes::problem_h::{Sizes, read, twin_scene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// Approach of the cut faces, in.
const APPROACH: f64 = 1e-3;

pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let (rough, smooth) = (pressed(0.15)?, pressed(0.0)?);
    let [with, without] = [&rough, &smooth].map(|run| read(&run.scene, run.state()));
    let (with, without) = (with?, without?);
    let shear = LadderClaim::small(
        "equal half cylinders, μ = 0.15: largest shear / p0",
        with.shear,
        1e-8,
    );
    let p0 = LadderClaim::relative(
        "p0 with friction against p0 without, ksi",
        with.pressure,
        without.pressure,
        1e-8,
    );
    Ok(vec![
        rough.claim(
            shear
                .from("symmetry")
                .because("mirror images move alike; a residual of 1e-11 and rounding remain"),
        ),
        rough.claim(
            p0.from("symmetry")
                .because("no shear, no difference; a residual of 1e-11 and rounding remain"),
        ),
    ])
}

fn pressed(friction: f64) -> Result<SolvedScene, VerifyError> {
    let mut scene = twin_scene(&Sizes::with(8), APPROACH, friction)?;
    // What is measured is the method, not how far it was iterated.
    scene.controls.residual = 1e-11;
    scene.controls.penetration = 1e-10;
    kit::run(scene)
}
