//! Solving L Y = B where columns of B have few entries: only the *reach* of these is worked on.
//!
//! The supernodes that an entry has to do with are those on the way from its own to the root of the elimination tree
//! (Gilbert and Peierls, SIAM J. Sci. Stat. Comput. 9 (1988) 862). Of a body of many elements these are few, and so are
//! the entries of Y.

use super::number::Number;
use super::triangles::Triangles;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, Par};
use rayon::prelude::*;
use std::ops::Range;

/// A column with few entries: equations and values.
pub type SparseColumn = Vec<(usize, f64)>;

/// Three columns of Y = L⁻¹ B: what may be unlike zero, in the order of elimination.
pub struct ReachedColumns {
    /// Rows, ascending.
    runs: Vec<Range<usize>>,
    values: [Vec<f64>; 3],
}

impl<T: Number> Triangles<'_, T> {
    /// Y for each three columns `b`, the entries of which are given by their place in the order of elimination. `None`
    /// where that takes more multiplications than `most`.
    pub fn reach(&self, b: &[[SparseColumn; 3]], most: f64) -> Option<Vec<ReachedColumns>> {
        let ways: Vec<Vec<usize>> = b.par_iter().map(|b| self.way(b)).collect();
        let entries = |s: &usize| (self.tree.value[s + 1] - self.tree.value[*s]) as f64;
        let work: f64 = 3.0 * ways.iter().flatten().map(entries).sum::<f64>();
        let rows = self.symbolic.nrows();
        let zeros = || vec![T::rounded(0.0); 3 * rows];
        let all = b.par_iter().zip(&ways);
        (work <= most).then(|| {
            all.map_init(zeros, |x, (b, way)| self.along(b, way, x))
                .collect()
        })
    }

    /// Supernodes that the entries of `b` have to do with, ascending.
    fn way(&self, b: &[SparseColumn; 3]) -> Vec<usize> {
        let tree = self.tree;
        let mut way = Vec::new();
        for (place, _) in b.iter().flatten() {
            let mut s = tree.begin.partition_point(|begin| begin <= place) - 1;
            while s < tree.len() && !way.contains(&s) {
                way.push(s);
                s = tree.parent[s];
            }
        }
        way.sort_unstable();
        way
    }

    /// Solves for three columns along the supernodes of their `way`; `x`, room for all rows, is zero before and after.
    fn along(&self, b: &[SparseColumn; 3], way: &[usize], x: &mut [T]) -> ReachedColumns {
        let rows = x.len() / 3;
        for (column, b) in x.chunks_mut(rows).zip(b) {
            for (place, value) in b {
                column[*place] += T::rounded(*value);
            }
        }
        let mut product = Vec::new();
        for s in way {
            let (triangle, rectangle, below) = self.block(*s);
            let mut all = MatMut::from_column_major_slice_mut(x, rows, 3);
            let mut own = (all.rb_mut()).submatrix_mut(self.tree.begin[*s], 0, triangle.ncols(), 3);
            solve_lower_triangular_in_place(triangle, own.rb_mut(), Par::Seq);
            product.resize(3 * below.len(), T::rounded(0.0));
            let out = MatMut::from_column_major_slice_mut(&mut product, below.len(), 3);
            let minus = T::rounded(-1.0);
            matmul(out, Accum::Replace, rectangle, own.rb(), minus, Par::Seq);
            let products = product.chunks(below.len().max(1));
            for (column, product) in x.chunks_mut(rows).zip(products) {
                for (row, value) in below.iter().zip(product) {
                    column[*row as usize] += *value;
                }
            }
        }
        let runs: Vec<_> = (way.iter())
            .map(|s| self.tree.begin[*s]..self.tree.begin[s + 1])
            .collect();
        let mut take = |column: usize| {
            let x = &mut x[column * rows..(column + 1) * rows];
            let own = runs.iter().flat_map(|run| &x[run.clone()]);
            let values = own.map(|v| v.widened()).collect();
            runs.iter()
                .for_each(|run| x[run.clone()].fill(T::rounded(0.0)));
            values
        };
        let values = [0, 1, 2].map(&mut take);
        ReachedColumns { runs, values }
    }
}

impl ReachedColumns {
    /// Yᵀ x
    pub fn pull(&self, x: &[f64]) -> [f64; 3] {
        self.values.each_ref().map(|values| {
            let rows = self.runs.iter().flat_map(|run| &x[run.clone()]);
            rows.zip(values).map(|(x, y)| x * y).sum()
        })
    }

    /// x ← x − Y f
    pub fn take_off(&self, f: [f64; 3], x: &mut [f64]) {
        for (values, f) in self.values.iter().zip(f) {
            let mut from = 0;
            for run in &self.runs {
                let own = &values[from..from + run.len()];
                (x[run.clone()].iter_mut().zip(own)).for_each(|(x, y)| *x -= f * y);
                from += run.len();
            }
        }
    }

    /// Yᵀ Z
    pub fn products(&self, other: &Self) -> [[f64; 3]; 3] {
        let mut sums = [[0.0; 3]; 3];
        let (mut a, mut b) = ((0, 0), (0, 0));
        while let (Some(own), Some(others)) = (self.runs.get(a.0), other.runs.get(b.0)) {
            // Both are made of whole supernodes.
            if own.start == others.start {
                for (line, values) in sums.iter_mut().zip(&self.values) {
                    for (sum, others) in line.iter_mut().zip(&other.values) {
                        let pairs = values[a.1..a.1 + own.len()].iter().zip(&others[b.1..]);
                        *sum += pairs.map(|(y, z)| y * z).sum::<f64>();
                    }
                }
            }
            let (first, second) = (own.start <= others.start, others.start <= own.start);
            if first {
                a = (a.0 + 1, a.1 + own.len());
            }
            if second {
                b = (b.0 + 1, b.1 + others.len());
            }
        }
        sums
    }
}
