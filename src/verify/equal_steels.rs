//! Two identical half cylinders on mirrored meshes with friction under a normal load.
//!
//! Mirror images approach each other without sliding: there is no shear to find, whatever μ.

use super::kit;
use super::problem_h::{Sizes, read, twin_scene};
use super::{Claim, Extent, VerifyError};

/// Approach of the cut faces, in.
const APPROACH: f64 = 1e-3;

pub fn claims(_: Extent) -> Result<Vec<Claim>, VerifyError> {
    let rough = kit::run(twin_scene(&Sizes::with(8), APPROACH, 0.15)?)?;
    let smooth = kit::run(twin_scene(&Sizes::with(8), APPROACH, 0.0)?)?;
    let [with, without] = [&rough, &smooth].map(|run| read(&run.scene, run.state()));
    let (with, without) = (with?, without?);
    let shear = Claim::small(
        "equal half cylinders, μ = 0.15: largest shear / p0",
        with.shear,
        1e-8,
    );
    let p0 = Claim::relative(
        "p0 with friction against p0 without, ksi",
        with.pressure,
        without.pressure,
        1e-8,
    );
    Ok(vec![
        rough.claim(
            shear
                .from("symmetry")
                .because("mirror images move alike; rounding and the residual of 1e-8 remain"),
        ),
        rough.claim(
            p0.from("symmetry")
                .because("no shear, no difference but the residual of 1e-8"),
        ),
    ])
}
