//! Problem H: a line contact without friction.

use super::problem::{NamedFigures, Problem};
use crate::proof::verify::kit::SolvedScene;
use crate::proof::verify::scenes::problem_h::{self, Sizes};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};

/// A line contact without friction.
pub fn claims(_: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    const PROBLEM: Problem = Problem {
        name: "problem H",
        scene: || problem_h::scene(&Sizes::with(8)),
        figures: of_problem_h,
    };
    PROBLEM.with_penalties(&[0.01, 100.0])
}

fn of_problem_h(run: &SolvedScene) -> Result<NamedFigures, VerifyError> {
    let read = problem_h::read(&run.scene, run.state())?;
    Ok(vec![
        ("p0, ksi", read.pressure),
        ("half-width, in", read.half_width),
        ("peak Mises in the block, ksi", read.block.integration_point),
        (
            "peak Mises in the cylinder, ksi",
            read.cylinder.integration_point,
        ),
    ])
}
