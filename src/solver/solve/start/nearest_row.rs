//! The least weighted gap of a pair.

use crate::model::scene::{ContactPair, Scene};
use crate::solver::contact::mortar::Row;
use crate::solver::solve::rows::contact_rows::pair_rows;
use crate::solver::solve::start::extent::extent;

/// The row of a pair with the least initial gap; `None` where nothing of the two sides faces each
/// other.
pub fn nearest_row(scene: &Scene, pair: &ContactPair) -> Option<Row> {
    let moduli = vec![1.0; scene.materials.len()];
    let whole = extent(scene);
    let mut reach = 1e-3 * whole;
    while reach < 2.0 * whole {
        let rows = pair_rows(scene, pair, (reach, &[]), &moduli);
        let nearest = rows.into_iter().min_by(|a, b| a.gap.total_cmp(&b.gap));
        if nearest.is_some() {
            return nearest;
        }
        reach *= 8.0;
    }
    None
}
