//! A problem, solved with other penalties than the usual one.

use std::time::Instant;

use crate::model::scene::Scene;
use crate::proof::verify::kit::SolvedScene;
use crate::proof::verify::{LadderClaim, VerifyError};
use crate::solver::solve::{Iteration, Observer, SolveError, solve};

/// Largest relative change of a figure.
const TOLERANCE: f64 = 2e-3;

/// Figures of a run by name.
pub type NamedFigures = Vec<(&'static str, f64)>;

/// A problem whose penalty is changed.
pub struct Problem {
    pub name: &'static str,
    pub scene: fn() -> Result<Scene, VerifyError>,
    pub figures: fn(&SolvedScene) -> Result<NamedFigures, VerifyError>,
}

/// Stops a solution that takes several times the iterations of the usual penalty.
#[derive(Default)]
struct IterationLimit {
    iterations: usize,
}

/// The bearing takes 60 with the usual penalty.
const MOST_ITERATIONS: usize = 250;

impl Observer for IterationLimit {
    fn iteration(&mut self, _: &Iteration) {
        self.iterations += 1;
    }

    fn cancelled(&self) -> bool {
        self.iterations > MOST_ITERATIONS
    }
}

impl Problem {
    /// Figures with other penalties against those with the usual one.
    pub fn with_penalties(&self, factors: &[f64]) -> Result<Vec<LadderClaim>, VerifyError> {
        let own = (self.figures)(&self.run(1.0)?.ok_or(VerifyError::Missing("solution"))?)?;
        let mut claims = Vec::new();
        for &factor in factors {
            let of = |what: &str| format!("{}, penalty x {factor}: {what}", self.name);
            let Some(run) = self.run(factor)? else {
                let unsolved = LadderClaim::small(of("converges"), f64::NAN, 0.0);
                claims.push(sourced(unsolved));
                continue;
            };
            for ((what, value), (_, reference)) in (self.figures)(&run)?.into_iter().zip(&own) {
                let claim = LadderClaim::relative(of(what), value, *reference, TOLERANCE);
                claims.push(run.claim(sourced(claim)));
            }
        }
        Ok(claims)
    }

    /// The problem solved with `factor` times the penalty; `None` where it does not converge.
    fn run(&self, factor: f64) -> Result<Option<SolvedScene>, VerifyError> {
        let mut scene = (self.scene)()?;
        for pair in &mut scene.contacts {
            pair.penalty_factor *= factor;
        }
        let start = Instant::now();
        let solution = match solve(&mut scene, &mut IterationLimit::default()) {
            Ok(solution) if solution.complete => solution,
            Ok(_) | Err(SolveError::NotConverged { .. } | SolveError::FreeBody { .. }) => {
                return Ok(None);
            }
            Err(error) => return Err(error.into()),
        };
        let seconds = start.elapsed().as_secs_f64();
        Ok(Some(SolvedScene {
            scene,
            solution,
            seconds,
        }))
    }
}

fn sourced(claim: LadderClaim) -> LadderClaim {
    claim
        .from("the same with penalty x 1")
        .because("augmented until contact conditions miss by 1e-8 of the approach")
}
