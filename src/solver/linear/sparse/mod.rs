//! Symmetric sparse matrices: the lower triangle, column by column, on a fixed pattern.

mod product;

use std::ops::Range;

/// Entries of a matrix that are worth a task of their own.
pub const ENTRIES_PER_TASK: usize = 1 << 16;

/// The pattern of a symmetric matrix whose equations come in vertices (a node's components).
///
/// Vertices that share a clique (an element, a contact row) are coupled in full.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// First equation of each vertex, and the number of equations at the end.
    pub vertex_start: Vec<u32>,
    /// Neighbours of each vertex, itself excluded, ascending: the graph that is ordered.
    pub adjacency_start: Vec<u32>,
    /// The neighbours themselves, vertex by vertex.
    pub adjacency: Vec<u32>,
    /// Start of each equation's column in `rows`.
    pub columns: Vec<u32>,
    /// Row of each entry, ascending within a column, diagonal first.
    pub rows: Vec<u32>,
    /// Rows below a vertex that it is coupled with, as stretches without a gap: condensed bodies leave long ones.
    stretches: Vec<Range<u32>>,
    /// Start of each vertex's stretches.
    stretch_start: Vec<u32>,
}

/// A symmetric matrix on a pattern.
#[derive(Debug, Clone, Default)]
pub struct SymmetricMatrix {
    /// Entries of the lower triangle, as the pattern's `rows`.
    pub values: Vec<f64>,
}

impl Pattern {
    /// From the vertices that stand together in each clique.
    pub fn new<'a>(
        vertex_start: Vec<u32>,
        cliques: impl Iterator<Item = &'a [u32]> + Clone,
    ) -> Self {
        let vertices = vertex_start.len().saturating_sub(1);
        let adjacency = neighbours(vertices, cliques);
        let mut adjacency_start = Vec::with_capacity(vertices + 1);
        let mut flat = Vec::new();
        adjacency_start.push(0);
        for list in adjacency {
            flat.extend(list);
            adjacency_start.push(flat.len() as u32);
        }
        let mut pattern = Self {
            vertex_start,
            adjacency_start,
            adjacency: flat,
            columns: vec![0],
            rows: Vec::new(),
            stretches: Vec::new(),
            stretch_start: vec![0],
        };
        pattern.fill_columns();
        pattern.fill_stretches();
        pattern
    }

    fn fill_stretches(&mut self) {
        for vertex in 0..self.vertex_start.len().saturating_sub(1) {
            let begun = self.stretches.len();
            let below = self
                .neighbours(vertex)
                .partition_point(|n| (*n as usize) < vertex);
            let after = self.adjacency_start[vertex] as usize + below;
            for &other in &self.adjacency[after..self.adjacency_start[vertex + 1] as usize] {
                let rows = self.vertex_start[other as usize]..self.vertex_start[other as usize + 1];
                match self.stretches[begun..].last_mut() {
                    Some(last) if last.end == rows.start => last.end = rows.end,
                    _ => self.stretches.push(rows),
                }
            }
            self.stretch_start.push(self.stretches.len() as u32);
        }
    }

    fn fill_columns(&mut self) {
        for vertex in 0..self.vertex_start.len().saturating_sub(1) {
            let own = self.vertex_start[vertex]..self.vertex_start[vertex + 1];
            for column in own.clone() {
                self.rows.extend(column..own.end);
                let range = self.adjacency_start[vertex] as usize
                    ..self.adjacency_start[vertex + 1] as usize;
                for &other in &self.adjacency[range] {
                    if other as usize > vertex {
                        let other = other as usize;
                        self.rows
                            .extend(self.vertex_start[other]..self.vertex_start[other + 1]);
                    }
                }
                self.columns.push(self.rows.len() as u32);
            }
        }
    }

    /// Vertices that share a clique with `vertex`, ascending.
    pub fn neighbours(&self, vertex: usize) -> &[u32] {
        let range = self.adjacency_start[vertex]..self.adjacency_start[vertex + 1];
        &self.adjacency[range.start as usize..range.end as usize]
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.columns.len() - 1
    }

    /// No equation at all?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Position of the entry at `row` >= `column`; the entry must be in the pattern.
    pub fn position(&self, row: u32, column: u32) -> usize {
        let start = self.columns[column as usize] as usize;
        let end = self.columns[column as usize + 1] as usize;
        start + self.rows[start..end].partition_point(|r| *r < row)
    }

    /// The block of row vertex `v` and column vertex `w`, which are neighbours or the same, of up
    /// to three equations each.
    pub fn block(&self, matrix: &SymmetricMatrix, v: u32, w: u32) -> [[f64; 3]; 3] {
        let of = |v: u32| self.vertex_start[v as usize]..self.vertex_start[v as usize + 1];
        let (columns, rows) = (of(v.min(w)), of(v.max(w)));
        let mut block = [[0.0; 3]; 3];
        for (j, column) in columns.enumerate() {
            // Within its own vertex a column begins with its diagonal.
            let skipped = if v == w { j } else { 0 };
            let first = rows.start + skipped as u32;
            let start = self.position(first, column);
            let values = &matrix.values[start..start + (rows.end - first) as usize];
            for (i, value) in values.iter().enumerate().map(|(i, v)| (i + skipped, *v)) {
                let (row, column) = if v < w { (j, i) } else { (i, j) };
                block[row][column] = value;
                if v == w {
                    block[column][row] = value;
                }
            }
        }
        block
    }

    /// A matrix of zeros.
    pub fn zeros(&self) -> SymmetricMatrix {
        SymmetricMatrix {
            values: vec![0.0; self.rows.len()],
        }
    }

    /// Adds a dense block: `value(i, j)` to row `equations[i]`, column `equations[j]`.
    ///
    /// Equations may repeat; `u32::MAX` is skipped. Only the lower triangle is stored.
    pub fn add_block(
        &self,
        matrix: &mut SymmetricMatrix,
        equations: &[u32],
        value: impl Fn(usize, usize) -> f64,
    ) {
        for (j, &column) in equations.iter().enumerate() {
            if column == u32::MAX {
                continue;
            }
            // Equations of one vertex follow each other, in the block and in the column: one search finds all of them.
            let end = self.columns[column as usize + 1] as usize;
            let mut next = end;
            for (i, &row) in equations.iter().enumerate() {
                if row != u32::MAX && row >= column {
                    let at = match next < end && self.rows[next] == row {
                        true => next,
                        false => self.position(row, column),
                    };
                    matrix.values[at] += value(i, j);
                    next = at + 1;
                }
            }
        }
    }

    /// The diagonal of `matrix`.
    pub fn diagonal(&self, matrix: &SymmetricMatrix) -> Vec<f64> {
        self.columns[..self.len()]
            .iter()
            .map(|start| matrix.values[*start as usize])
            .collect()
    }
}

/// Neighbour lists of the graph whose cliques are given.
fn neighbours<'a>(
    vertices: usize,
    cliques: impl Iterator<Item = &'a [u32]> + Clone,
) -> Vec<Vec<u32>> {
    let mut lists = vec![Vec::new(); vertices];
    for clique in cliques {
        for &a in clique {
            let list = &mut lists[a as usize];
            list.extend(clique.iter().copied().filter(|b| *b != a));
            // Keep the lists short while they grow.
            if list.len() > 256 && list.len().is_power_of_two() {
                list.sort_unstable();
                list.dedup();
            }
        }
    }
    for list in &mut lists {
        list.sort_unstable();
        list.dedup();
        list.shrink_to_fit();
    }
    lists
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_and_its_product() {
        let cliques: Vec<Vec<u32>> = vec![vec![0, 1], vec![1, 2]];
        let pattern = Pattern::new(vec![0, 2, 3, 5], cliques.iter().map(Vec::as_slice));
        assert_eq!(pattern.len(), 5);
        let mut m = pattern.zeros();
        pattern.add_block(&mut m, &[0, u32::MAX, 2], |i, j| (1 + i + j) as f64);
        let mut y = vec![0.0; 5];
        pattern.multiply(&m, &[1.0, 0.0, 2.0, 0.0, 0.0], &mut y);
        assert_eq!(y, [1.0 + 2.0 * 3.0, 0.0, 3.0 + 2.0 * 5.0, 0.0, 0.0]);
    }
}
