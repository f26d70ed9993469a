//! A solution with its cost.

use crate::model::scene::Scene;
use crate::model::state::State;
use crate::proof::verify::{Claim, VerifyError};
use crate::solver::solve::{Silent, Solution, solve};
use std::time::Instant;

/// A solved scene and what it cost.
pub struct Run {
    pub scene: Scene,
    pub solution: Solution,
    pub seconds: f64,
}

/// Solves a scene that is expected to converge.
pub fn run(mut scene: Scene) -> Result<Run, VerifyError> {
    let start = Instant::now();
    let solution = solve(&mut scene, &mut Silent)?;
    Ok(Run {
        scene,
        solution,
        seconds: start.elapsed().as_secs_f64(),
    })
}

impl Run {
    /// The last accepted state.
    pub fn state(&self) -> &State {
        &self.solution.last
    }

    /// The claim with the unknowns and seconds of this run.
    pub fn claim(&self, claim: Claim) -> Claim {
        Claim {
            dofs: self.solution.counters.equations,
            seconds: self.seconds,
            ..claim
        }
    }
}
