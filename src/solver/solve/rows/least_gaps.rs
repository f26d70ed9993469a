//! How far rows stand open, over the least gap of their pair.

use crate::solver::solve::rows::contact_row::ContactRow;

/// The least initial gap of each pair.
pub struct LeastGaps(Vec<f64>);

impl LeastGaps {
    /// Of some rows.
    pub fn of<'r>(rows: impl IntoIterator<Item = &'r ContactRow>) -> Self {
        let mut least: Vec<f64> = Vec::new();
        for row in rows {
            if least.len() <= row.pair {
                least.resize(row.pair + 1, f64::INFINITY);
            }
            least[row.pair] = row.row.gap.min(least[row.pair]);
        }
        Self(least)
    }

    /// That of each pair up to the last one with a row, in their order; infinite where a pair has none.
    pub fn each(&self) -> impl Iterator<Item = f64> {
        self.0.iter().copied()
    }

    /// The initial gap of a row of these pairs over the least one of its pair.
    pub fn beyond(&self, row: &ContactRow) -> f64 {
        row.row.gap - self.0[row.pair]
    }
}
