//! What solving a scene will take, reckoned without solving it.

use crate::ground::geometry::Vec3;
use crate::model::half_turn::HalfTurn;
use crate::model::scene::Scene;
use crate::solver::fem::tied::Tied;
use crate::solver::solve::checkpoint::expected::Expected;
use crate::solver::solve::condensed::size::Size;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::model::structure::needed;
use crate::solver::solve::params::{
    ITERATIONS_PER_INCREMENT, ITERATIONS_PER_PATH_FREE_STEP, SECONDS_PER_UNKNOWN_ITERATION,
};
use crate::solver::solve::recovery::memory::memory_of_states;
use crate::solver::solve::rigid::free_motion::{FreeMotion, free_motions};
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::rows::contact_rows::contact_rows;
use crate::solver::solve::start::can_yield::can_yield;
use crate::solver::solve::start::close_gaps::{Closing, touch};
use crate::solver::solve::start::nearest_row::nearest_row;
use crate::solver::solve::ties::unknowns::{equations, tied};
use std::sync::Arc;

/// What solving a scene will take.
#[derive(Debug, Clone, PartialEq)]
pub struct Forecast {
    /// Unknowns in all.
    pub unknowns: usize,
    /// Is it its own image under a half turn, so that one half is solved?
    pub half_turn: bool,
    /// Unknowns that contact acts on, which iterations cannot do without.
    pub kept: usize,
    /// Will it be divided, and not factored as a whole?
    pub divided: bool,
    /// Bytes, as they are reckoned before the factorisation: from runs of 50 to 200 thousand
    /// unknowns, within a quarter.
    pub memory: f64,
    /// Newton iterations, roughly.
    pub iterations: f64,
    /// Seconds of the processor, summed over threads, roughly.
    pub processor_s: f64,
    /// Elements of steels that can yield.
    pub can_yield: usize,
    /// The contact pairs, in the order of the scene.
    pub pairs: Vec<PairForecast>,
    /// Bodies that will be moved into touch before the load.
    pub closings: Vec<Closing>,
    /// Motions that nothing resists.
    pub free: Vec<FreeMotion>,
}

/// A contact pair before the load.
#[derive(Debug, Clone, PartialEq)]
pub struct PairForecast {
    /// Its name in the scene.
    pub name: String,
    /// Least gap as meshed, open positive; `None` where the sides do not face each other.
    pub gap: Option<f64>,
    /// The same once floating bodies have been moved into touch.
    pub gap_at_touch: Option<f64>,
    /// Where that is, the carrier's node, and the unit normal from the carrier to the other side.
    pub at: Option<(u32, Vec3)>,
    /// Contact nodes that are likely to close,
    pub likely: usize,
    /// and all within reach.
    pub within_reach: usize,
}

/// Reckons what solving `scene` will take. Floating bodies are moved into touch, as a solution
/// does first.
///
/// # Errors
/// [`SolveError`] where supports contradict each other or nothing is free.
pub fn forecast(scene: &mut Scene) -> Result<Forecast, SolveError> {
    let least = |scene: &Scene| -> Vec<_> {
        let pairs = scene.contacts.iter();
        pairs.map(|pair| nearest_row(scene, pair)).collect()
    };
    let before = least(scene);
    let closings = touch(scene);
    let after = if closings.is_empty() {
        before.clone()
    } else {
        least(scene)
    };
    let half_turn = HalfTurn::of(scene).ok();
    let tied = tied(scene)?;
    let expected = Expected::at_start(scene);
    let (rows, spare) = expected.split(contact_rows(scene, &tied, expected.reach));
    let of = |rows: &[ContactRow], pair: usize| rows.iter().filter(|r| r.pair == pair).count();
    let pairs = (scene.contacts.iter().zip(before).zip(after)).enumerate();
    let pairs = pairs.map(|(index, ((pair, before), after))| PairForecast {
        name: pair.name.clone(),
        gap: before.map(|row| row.gap),
        gap_at_touch: after.as_ref().map(|row| row.gap),
        at: after.map(|row| (row.node, row.normal)),
        likely: of(&rows, index),
        within_reach: of(&rows, index) + of(&spare, index),
    });
    let pairs = pairs.collect();
    let (unknowns, size) = match &half_turn {
        Some(half_turn) => {
            let rows = contact_rows(&half_turn.half, &tied, expected.reach);
            size(&half_turn.half, tied, &expected.split(rows).0)?
        }
        None => size(scene, tied, &rows)?,
    };
    let can_yield = (0..scene.mesh.hexes.len() as u32).filter(|e| can_yield(scene, *e));
    let can_yield = can_yield.count();
    let iterations = iterations(scene, can_yield > 0);
    Ok(Forecast {
        unknowns,
        half_turn: half_turn.is_some(),
        kept: size.kept as usize,
        divided: size.divided,
        memory: size.memory + memory_of_states(scene),
        iterations,
        processor_s: processor_seconds(unknowns, iterations),
        can_yield,
        pairs,
        closings,
        free: free_motions(scene, &rows),
    })
}

/// Unknowns of a scene whose bodies touch, and what its model takes, contact being likely to close at `rows`.
fn size(scene: &Scene, tied: Arc<Tied>, rows: &[ContactRow]) -> Result<(usize, Size), SolveError> {
    let dofs = equations(scene, tied)?;
    if dofs.is_empty() {
        return Err(SolveError::NothingFree);
    }
    let needed = needed(scene, &dofs, rows, &[]);
    Ok((dofs.len(), Size::new(scene, &dofs, &needed, (&[], false))))
}

/// About how many Newton iterations the steps take: a few where nothing depends on the path, eight an
/// increment of the first size where something does.
fn iterations(scene: &Scene, yields: bool) -> f64 {
    let a_step = if yields || scene.rubs() {
        ITERATIONS_PER_INCREMENT / scene.controls.first_increment
    } else {
        ITERATIONS_PER_PATH_FREE_STEP
    };
    scene.steps.len() as f64 * a_step
}

/// Seconds of the processor: in `docs/performance.md` bearings of 36 thousand to a million unknowns
/// take 0.9 to 1.6e-5 s an unknown and iteration.
fn processor_seconds(unknowns: usize, iterations: f64) -> f64 {
    SECONDS_PER_UNKNOWN_ITERATION * unknowns as f64 * iterations
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unknowns, and seconds of the processor, of bearings in `docs/performance.md`: 32 iterations
    /// are reckoned for each of them.
    #[test]
    fn measured_times_are_within_a_factor_of_three() {
        let measured = [
            (35_883, 7.41),
            (98_533, 28.1),
            (52_669, 29.2),
            (103_690, 49.3),
            (198_175, 127.0),
            (429_625, 369.0),
            (1_030_846, 1061.0),
        ];
        for (unknowns, seconds) in measured {
            let ratio = processor_seconds(unknowns, 32.0) / seconds;
            assert!((1.0 / 3.0..3.0).contains(&ratio), "{unknowns}: {ratio}");
        }
    }
}
