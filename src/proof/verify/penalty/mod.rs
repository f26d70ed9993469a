//! The answer does not depend on the penalty of the contact.
//!
//! The penalty is the slope of an augmented Lagrangian, so a hundred times more or less of it must
//! leave every figure where it is. What may move is bounded by the tolerances of the increment.

use std::time::Instant;

use super::kit::Run;
use super::problem_h::{self, Sizes};
use super::{Claim, Extent, VerifyError};
use crate::model::scene::Scene;
use crate::solver::solve::{Iteration, Observer, SolveError, solve};

mod bearing;

const TOLERANCE: f64 = 2e-3;

/// Figures of a run by name.
type Figures = Vec<(&'static str, f64)>;

/// A problem whose penalty is changed.
struct Problem {
    name: &'static str,
    scene: fn() -> Result<Scene, VerifyError>,
    figures: fn(&Run) -> Result<Figures, VerifyError>,
}

/// A line contact without friction.
pub fn claims(_: Extent) -> Result<Vec<Claim>, VerifyError> {
    const PROBLEM: Problem = Problem {
        name: "problem H",
        scene: || problem_h::scene(&Sizes::with(8)),
        figures: of_problem_h,
    };
    PROBLEM.with_penalties(&[0.01, 100.0])
}

/// A bearing with friction that yields; nothing where only the fast part of the ladder is wanted.
pub fn claims_of_bearing(extent: Extent) -> Result<Vec<Claim>, VerifyError> {
    const PROBLEM: Problem = Problem {
        name: "centre case, h025",
        scene: bearing::scene,
        figures: bearing::figures,
    };
    match extent {
        Extent::Fast => Ok(Vec::new()),
        Extent::All => PROBLEM.with_penalties(&[0.1, 10.0, 0.01, 100.0]),
    }
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
    fn with_penalties(&self, factors: &[f64]) -> Result<Vec<Claim>, VerifyError> {
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

fn of_problem_h(run: &Run) -> Result<Figures, VerifyError> {
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
