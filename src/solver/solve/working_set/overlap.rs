//! Where surfaces overlap and no contact row acts.

use crate::solver::contact::facing::Sight;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::rows::contact_row::ContactRow;
use crate::solver::solve::rows::least_gaps::LeastGaps;
use crate::solver::solve::start::extent::extent;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Where surfaces overlap and no row that was kept acts.
///
/// The gaps that are looked at here know nothing of rows: from each node and the middle of each facet the other surface
/// is sought along the normal ([`Sight`]).
pub struct Overlap {
    /// The largest initial gap, over the least of its pair, of rows that were left out there.
    pub left_out: Option<f64>,
    /// Where no row exists at all: the initial gap up to which contact has to be integrated, at least.
    pub not_integrated: Option<f64>,
}

impl Overlap {
    /// Every node of a carrier facet that overlaps has to have its row, however small the overlap.
    pub fn find(model: &Model, sights: &[Vec<Sight>], u: &[[f64; 3]]) -> Self {
        let mut overlapped: BTreeMap<(usize, u32), f64> = BTreeMap::new();
        for (pair, sights) in sights.iter().enumerate() {
            let found = sights.par_iter().filter(|s| s.gap_at(u) < 0.0);
            let found: Vec<_> = found.map(|s| s.carrier.0).collect();
            if found.is_empty() {
                continue;
            }
            // All nodes of a facet have rows once all of it is integrated.
            let mut widest: BTreeMap<[u32; 4], f64> = BTreeMap::new();
            for sight in sights.iter().filter(|s| s.gap.is_finite()) {
                let gap = widest.entry(sight.carrier.0).or_default();
                *gap = gap.max(sight.gap);
            }
            for facet in found {
                for node in facet {
                    let gap = overlapped.entry((pair, node)).or_default();
                    *gap = gap.max(widest.get(&facet).copied().unwrap_or_default());
                }
            }
        }
        // Takes the nodes of a row away: was one of them overlapped?
        let mut take = |row: &ContactRow| {
            let nodes = row.row.nodes();
            let taken = nodes.filter(|node| overlapped.remove(&(row.pair, *node)).is_some());
            taken.count() > 0
        };
        model.rows.iter().for_each(|row| {
            take(row);
        });
        let least = LeastGaps::of(&model.rows);
        let spare = model.spare.iter().filter(|row| take(row));
        let left_out = spare.map(|row| least.beyond(row)).reduce(f64::max);
        // Beyond the size of the model nothing more can be integrated.
        let could = model.reach < extent(model.scene);
        let gaps = overlapped.values().copied().filter(|_| could);
        Self {
            left_out,
            not_integrated: gaps.map(|gap| gap.max(model.reach)).reduce(f64::max),
        }
    }
}

/// The next row of a pair all of whose rows that were kept are closed: contact may go on beyond them.
pub fn closed_throughout<'m>(model: &'m Model, x: &Point) -> Option<&'m ContactRow> {
    let mut open = vec![false; model.scene.contacts.len()];
    for (row, node) in model.rows.iter().zip(&x.nodes) {
        open[row.pair] |= !node.closed;
    }
    let rows = model.spare.iter().filter(|r| !open[r.pair]);
    rows.min_by(|a, b| a.row.gap.total_cmp(&b.row.gap))
}

/// The largest initial gap, over the least one of its pair, of the rows that are closed.
pub fn farthest_closed(model: &Model, x: &Point) -> f64 {
    let least = LeastGaps::of(&model.rows);
    let closed = model.rows.iter().zip(&x.nodes).filter(|(_, n)| n.closed);
    closed.map(|(row, _)| least.beyond(row)).fold(0.0, f64::max)
}
