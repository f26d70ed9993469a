//! Where the entries of a matrix go in its factor.

use crate::solver::linear::sparse::Pattern;

/// The pattern in the order of the factor: of each column its rows, and where their values are.
pub(super) struct Entries {
    /// Start of each column in `rows` and `places`, in the order of elimination.
    pub columns: Vec<usize>,
    /// Row of each entry, in the order of elimination.
    pub rows: Vec<u32>,
    /// Where its value is in the matrix.
    pub places: Vec<u32>,
}

impl Entries {
    /// Of a pattern whose equations are eliminated in `order`.
    pub fn new(pattern: &Pattern, order: &[u32]) -> Self {
        let n = order.len();
        let mut position = vec![0u32; n];
        for (k, equation) in order.iter().enumerate() {
            position[*equation as usize] = k as u32;
        }
        let entries = || {
            (0..n).flat_map(|c| {
                let range = pattern.columns[c]..pattern.columns[c + 1];
                range.map(move |k| (c, k as usize))
            })
        };
        let place = |column: usize, k: usize| {
            let (a, b) = (position[column], position[pattern.rows[k] as usize]);
            (a.min(b), a.max(b))
        };
        let mut columns = vec![0usize; n + 1];
        for (c, k) in entries() {
            columns[place(c, k).0 as usize + 1] += 1;
        }
        for i in 0..n {
            columns[i + 1] += columns[i];
        }
        let mut next = columns.clone();
        let mut rows = vec![0u32; pattern.rows.len()];
        let mut places = vec![0u32; pattern.rows.len()];
        for (c, k) in entries() {
            let (column, row) = place(c, k);
            let at = &mut next[column as usize];
            (rows[*at], places[*at]) = (row, k as u32);
            *at += 1;
        }
        Self {
            columns,
            rows,
            places,
        }
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.columns.len() - 1
    }
}
