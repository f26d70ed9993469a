//! A solution with its cost.

use crate::model::scene::Scene;
use crate::model::state::State;
use crate::proof::verify::{LadderClaim, VerifyError};
use crate::solver::solve::{Silent, Solution, solve};
use std::time::Instant;

/// A solved scene and what it cost.
pub struct SolvedScene {
    pub scene: Scene,
    pub solution: Solution,
    pub seconds: f64,
}

/// Solves a scene that is expected to converge.
pub fn run(mut scene: Scene) -> Result<SolvedScene, VerifyError> {
    let start = Instant::now();
    let solution = solve(&mut scene, &mut Silent)?;
    Ok(SolvedScene {
        scene,
        solution,
        seconds: start.elapsed().as_secs_f64(),
    })
}

impl SolvedScene {
    /// The last accepted state.
    pub fn state(&self) -> &State {
        &self.solution.last
    }

    /// The claim with the unknowns and seconds of this run.
    pub fn claim(&self, claim: LadderClaim) -> LadderClaim {
        LadderClaim {
            dofs: self.solution.counters.equations,
            seconds: self.seconds,
            ..claim
        }
    }
}
