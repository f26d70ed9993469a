//! What solving a scene will take, reckoned without solving it.

use super::error::SolveError;
use super::foresight::Expected;
use super::holding::{FreeMotion, free_motions};
use super::model::{can_yield, needed};
use super::rows::{ContactRow, contact_rows};
use super::size::Size;
use super::start::{Closing, nearest_row, touch};
use crate::ground::geometry::Vec3;
use crate::model::scene::Scene;
use crate::solver::fem::dofs::DofMap;

/// What solving a scene will take.
#[derive(Debug, Clone, PartialEq)]
pub struct Forecast {
    /// Number of unknowns.
    pub unknowns: usize,
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
    /// Of each contact pair, in the order of the scene.
    pub pairs: Vec<PairForecast>,
    /// Bodies that will be moved into touch before the load.
    pub closings: Vec<Closing>,
    /// Motions that nothing resists.
    pub free: Vec<FreeMotion>,
}

/// A contact pair before the load.
#[derive(Debug, Clone, PartialEq)]
pub struct PairForecast {
    /// Name of the pair.
    pub name: String,
    /// Least gap as meshed, open positive; `None` where the sides do not face each other.
    pub gap: Option<f64>,
    /// The same once floating bodies have been moved into touch.
    pub gap_at_touch: Option<f64>,
    /// Where that is, the carrier's node, and the unit normal from the carrier to the other side.
    pub at: Option<(u32, Vec3)>,
    /// Contact nodes that are likely to close, and all within reach.
    pub likely: usize,
    /// Nodes of its carrier that the other side is within reach of.
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
    let after = match closings.is_empty() {
        true => before.clone(),
        false => least(scene),
    };
    let dofs = DofMap::new(scene)?;
    if dofs.is_empty() {
        return Err(SolveError::NothingFree);
    }
    let expected = Expected::at_start(scene);
    let (rows, spare) = expected.split(contact_rows(scene, expected.reach));
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
    let size = Size::new(
        scene,
        &dofs,
        &needed(scene, &dofs, &rows, &[]),
        (&[], false),
    );
    let can_yield = (0..scene.mesh.hexes.len() as u32).filter(|e| can_yield(scene, *e));
    let can_yield = can_yield.count();
    let iterations = iterations(scene, can_yield > 0);
    Ok(Forecast {
        unknowns: dofs.len(),
        kept: size.kept as usize,
        divided: size.divided,
        memory: size.memory,
        iterations,
        processor_s: processor_seconds(dofs.len(), iterations),
        can_yield,
        pairs,
        closings,
        free: free_motions(scene, &rows),
    })
}

/// About how many Newton iterations the steps take: a few where nothing depends on the path, eight an
/// increment of the first size where something does.
fn iterations(scene: &Scene, yields: bool) -> f64 {
    const AT_ONCE: f64 = 5.0;
    const AN_INCREMENT: f64 = 8.0;
    let rubs = scene.contacts.iter().any(|pair| pair.friction > 0.0);
    let a_step = match yields || rubs {
        true => AN_INCREMENT / scene.controls.first_increment,
        false => AT_ONCE,
    };
    scene.steps.len() as f64 * a_step
}

/// Seconds of the processor: in `docs/performance.md` bearings of 36 thousand to a million unknowns
/// take 0.9 to 1.6e-5 s an unknown and iteration.
fn processor_seconds(unknowns: usize, iterations: f64) -> f64 {
    1.4e-5 * unknowns as f64 * iterations
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
