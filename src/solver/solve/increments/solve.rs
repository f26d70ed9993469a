//! Solving a scene from its start, or from a checkpoint on.

use crate::model::half_turn::HalfTurn;
use crate::model::scene::Scene;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::checkpoint::restart::Restart;
use crate::solver::solve::checkpoint::timers::{Phase, Timers};
use crate::solver::solve::error::SolveError;
use crate::solver::solve::increments::run::Run;
use crate::solver::solve::increments::solution::{Solution, Unfinished};
use crate::solver::solve::model::system::Model;
use crate::solver::solve::observer::Observer;
use crate::solver::solve::params::ROUNDED_GAP;
use crate::solver::solve::recovery::memory::memory_of_states;
use crate::solver::solve::rows::contact_rows::{contact_rows, sights};
use crate::solver::solve::rows::least_gaps::LeastGaps;
use crate::solver::solve::start::close_gaps::{Closing, touch};
use crate::solver::solve::start::extent::extent;
use crate::solver::solve::ties::unknowns::tied;
use crate::solver::solve::unfolding::Unfolding;

/// Solves `scene`, telling `observer` of every iteration and increment.
///
/// The mesh of the scene may be moved: bodies that float are brought into touch first, and the
/// displacements count from there.
///
/// # Errors
/// [`SolveError`]; increments accepted before were handed to the observer.
pub fn solve(scene: &mut Scene, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    resume(scene, None, observer).map_err(|unfinished| unfinished.error)
}

/// Goes on with `scene` after the increment that `restart` was made at, or from the start.
///
/// The scene is the one that the first run began with: floating bodies are moved into touch again.
///
/// # Errors
/// As [`solve`], and where `restart` belongs to another scene.
pub fn resume(
    scene: &mut Scene,
    restart: Option<&Restart>,
    observer: &mut dyn Observer,
) -> Result<Solution, Unfinished> {
    let closings = touch(scene);
    for c in &closings {
        let s = c.shift;
        observer.message(&format!(
            "{} moved by [{:.3e}, {:.3e}, {:.3e}] to close its gap",
            c.body, s[0], s[1], s[2]
        ));
    }
    observer.moved(scene);
    match HalfTurn::of(scene) {
        Ok(half_turn) => {
            observer.message("its own image under a half turn about x = y: one half is solved");
            let mut observer = Unfolding {
                half_turn: &half_turn,
                observer,
            };
            let half = solve_touching(&half_turn.half, restart, closings, &mut observer);
            half.map(|solution| solution.unfolded(&half_turn))
                .map_err(|unfinished| unfinished.unfolded(&half_turn))
        }
        Err(reason) => {
            if reason.is_worth_telling() {
                observer.message(&format!("no half-turn symmetry: {reason}"));
            }
            solve_touching(scene, restart, closings, observer)
        }
    }
}

/// Solves a scene whose bodies touch.
fn solve_touching(
    scene: &Scene,
    restart: Option<&Restart>,
    closings: Vec<Closing>,
    observer: &mut dyn Observer,
) -> Result<Solution, Unfinished> {
    restart.map_or(Ok(()), |restart| restart.check(scene))?;
    let mut timers = Timers::default();
    let expected = match restart {
        Some(restart) => restart.expected.clone(),
        None => Expected::at_start(scene),
    };
    let model = timers.time(Phase::Prepare, || {
        let tied = tied(scene)?;
        let rows = contact_rows(scene, &tied, expected.reach);
        Model::new(scene, &expected, (rows, tied))
    })?;
    let mut run = Run::new(model, expected, observer);
    run.sights = timers.time(Phase::Prepare, || {
        sights(run.model.scene, extent(run.model.scene))
    });
    run.counters.timers = timers;
    if let Some(restart) = restart {
        run.go_on_from(restart);
    }
    run.observer.message(&format!(
        "{} unknowns, about {:.2} GB of memory",
        run.counters.equations,
        1e-9 * (run.model.memory + memory_of_states(scene))
    ));
    for name in run.untouched() {
        run.observer
            .message(&format!("contact pair {name}: nothing is within reach"));
    }
    let ended = run.all_steps();
    let stuck = ended.as_ref().err().and_then(|error| run.stuck(error));
    let ended = if stuck.is_some() { Ok(true) } else { ended };
    let stays = run.stays();
    let overlapping = overlapping(&run.model);
    let solution = Solution {
        overlapping,
        states: run.states,
        last: run.last,
        elastic: run.beside.elastic.map(|kept| kept.restore(&run.model)),
        elastic_doubled: (run.beside.elastic_doubled).map(|kept| kept.restore(&run.model)),
        doubled: (run
            .beside
            .doubled
            .iter()
            .map(|kept| kept.restore(&run.model)))
        .collect(),
        laborious: (run.counters.effort).reason(run.counters.iterations, run.counters.cut_backs),
        stays,
        counters: run.counters,
        closings,
        half_turn: false,
        complete: matches!(ended, Ok(true)),
        interrupted: matches!(ended, Ok(false)),
        stuck,
    };
    match ended {
        Ok(_) => Ok(solution),
        Err(error) => Err(Unfinished {
            error,
            solution: (!solution.last.displacement.is_empty()).then(|| Box::new(solution)),
        }),
    }
}

/// See [`Solution::overlapping`]. What is moved into touch overlaps by rounding.
fn overlapping(model: &Model) -> Vec<(String, f64)> {
    let nothing = ROUNDED_GAP * extent(model.scene);
    let least = LeastGaps::of(&model.rows);
    let pairs = model.scene.contacts.iter().zip(least.each());
    let overlaps = pairs.filter(|(_, gap)| *gap < -nothing);
    overlaps
        .map(|(pair, gap)| (pair.name.clone(), -gap))
        .collect()
}
