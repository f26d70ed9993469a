//! The least weighted gap of a pair, and the way to it.

use crate::model::scene::{ContactPair, Scene};
use crate::solver::contact::mortar::Row;
use crate::solver::solve::rows::contact_rows::pair_rows;
use crate::solver::solve::start::extent::extent;
use std::iter;

/// The row of a pair with the least initial gap; `None` where nothing of the two sides faces each
/// other.
pub fn nearest_row(scene: &Scene, pair: &ContactPair) -> Option<Row> {
    within_reaches(scene, pair)
        .find_map(|(_, rows)| rows.into_iter().min_by(|a, b| a.gap.total_cmp(&b.gap)))
}

/// How far a side has to go until it touches the other, by the rate at which each row closes on that way; `None` where it comes
/// no nearer anywhere.
///
/// Rows that hardly close say little: on the flank of a bore a millionth of gap is a long way. Those count that close half as
/// fast as the fastest.
///
/// What overlaps goes back. A body that then overlaps on its other side is a press fit, and stays where it is.
pub fn way_to_touch(scene: &Scene, pair: &ContactPair, rate: impl Fn(&Row) -> f64) -> Option<f64> {
    const SLOWEST: f64 = 0.1;
    /// Of an overlap, how much is left on the other side of what is pressed in.
    const LEFT: f64 = 0.1;
    let mut nearest = None;
    for (reach, rows) in within_reaches(scene, pair) {
        let fastest = rows.iter().map(&rate).fold(0.0, f64::max);
        let counts = |row: &&Row| rate(row) > SLOWEST.max(0.5 * fastest);
        let ways = rows.iter().filter(counts).map(|row| row.gap / rate(row));
        nearest = ways.reduce(f64::min).or(nearest);
        if let Some(way) = nearest.filter(|way| *way < 0.0) {
            let gap_after = |way: f64| {
                let gaps = rows.iter().map(|row| row.gap - rate(row) * way);
                gaps.fold(f64::INFINITY, f64::min)
            };
            if gap_after(way) < LEFT * gap_after(0.0) {
                return Some(0.0);
            }
        }
        // What is beyond the reach may be nearer along the way than a slow row within it.
        if nearest.is_some_and(|way| way <= reach) {
            break;
        }
    }
    nearest
}

/// The rows of a pair within a reach, and within larger and larger ones up to the whole scene.
fn within_reaches(scene: &Scene, pair: &ContactPair) -> impl Iterator<Item = (f64, Vec<Row>)> {
    let moduli = vec![1.0; scene.materials.len()];
    let whole = extent(scene);
    let reaches = iter::successors(Some(1e-3 * whole), |reach| Some(8.0 * reach));
    let reaches = reaches.take_while(move |reach| *reach < 2.0 * whole);
    reaches.map(move |reach| (reach, pair_rows(scene, pair, (reach, &[]), &moduli)))
}
