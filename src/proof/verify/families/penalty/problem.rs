//! A problem, solved with other penalties than the usual one.

use std::time::Instant;

use crate::model::scene::Scene;
use crate::proof::verify::kit::Run;
use crate::proof::verify::{Claim, VerifyError};
use crate::solver::solve::{Iteration, Observer, SolveError, solve};

/// Largest relative change of a figure.
const TOLERANCE: f64 = 2e-3;

/// Figures of a run by name.
pub type Figures = Vec<(&'static str, f64)>;

/// A problem whose penalty is changed.
pub struct Problem {
    pub name: &'static str,
    pub scene: fn() -> Result<Scene, VerifyError>,
    pub figures: fn(&Run) -> Result<Figures, VerifyError>,
}

/// Stops a solution that takes several times the iterations of the usual penalty.
#[derive(Default)]
struct Patience {
    iterations: usize,
}

/// The bearing takes 60 with the usual penalty.
const PATIENCE: usize = 250;

impl Observer for Patience {
    fn iteration(&mut self, _: &Iteration) {
        self.iterations += 1;
    }

    fn cancelled(&self) -> bool {
        self.iterations > PATIENCE
    }
}

impl Problem {
    /// Figures with other penalties against those with the usual one.
    pub fn with_penalties(&self, factors: &[f64]) -> Result<Vec<Claim>, VerifyError> {
        let own = (self.figures)(&self.run(1.0)?.ok_or(VerifyError::Missing("solution"))?)?;
        let mut claims = Vec::new();
        for &factor in factors {
            let of = |what: &str| format!("{}, penalty x {factor}: {what}", self.name);
            let Some(run) = self.run(factor)? else {
                let unsolved = Claim::small(of("converges"), f64::NAN, 0.0);
                claims.push(sourced(unsolved));
                continue;
            };
            for ((what, value), (_, reference)) in (self.figures)(&run)?.into_iter().zip(&own) {
                let claim = Claim::relative(of(what), value, *reference, TOLERANCE);
                claims.push(run.claim(sourced(claim)));
            }
        }
        Ok(claims)
    }

    /// The problem solved with `factor` times the penalty; `None` where it does not converge.
    fn run(&self, factor: f64) -> Result<Option<Run>, VerifyError> {
        let mut scene = (self.scene)()?;
        for pair in &mut scene.contacts {
            pair.penalty_factor *= factor;
        }
        let start = Instant::now();
        let solution = match solve(&mut scene, &mut Patience::default()) {
            Ok(solution) if solution.complete => solution,
            Ok(_) | Err(SolveError::NotConverged { .. } | SolveError::FreeBody { .. }) => {
                return Ok(None);
            }
            Err(error) => return Err(error.into()),
        };
        let seconds = start.elapsed().as_secs_f64();
        Ok(Some(Run {
            scene,
            solution,
            seconds,
        }))
    }
}

fn sourced(claim: Claim) -> Claim {
    claim
        .from("the same with penalty x 1")
        .because("augmented until contact conditions miss by 1e-8 of the approach")
}
