//! Solving with a factor on several threads: the subtrees of the elimination tree side by side.
//!
//! Words as in [`super::subtrees`]. Forward, L y = b: a supernode solves with its triangle, and takes its rectangle times
//! the answer off the rows below, which belong to supernodes above it. Backward, Lᵀ x = y: it takes off what those give,
//! and solves with the transposed triangle. Either way a subtree needs nothing of the others: what it takes off rows above
//! all subtrees is put by, and taken off when all are done, one share after the other.
//!
//! A solution reads the whole factor twice and does little else. So the shares of the threads are even in entries, and not
//! in the work of the factor.

use super::number::Number;
use super::tree::{Split, Tree};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::prelude::{Reborrow, ReborrowMut};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{Accum, MatMut, MatRef, Par};
use rayon::prelude::*;
use std::ops::Range;

/// A factor to solve with.
pub(in crate::solver::linear) struct Triangles<'a, T> {
    pub symbolic: &'a SymbolicSupernodalCholesky<u32>,
    pub tree: &'a Tree,
    /// Values of the factor.
    pub values: &'a [T],
    /// Threads that share the work.
    pub threads: usize,
}

/// Supernodes that follow each other, and what a vector has for their columns.
struct Stretch<'x, T> {
    supernodes: Range<usize>,
    /// The first of the columns.
    base: usize,
    x: &'x mut [T],
}

impl<T: Number> Triangles<'_, T> {
    /// Replaces b by y with L y = b; where the elimination ends before, kept entries by what it leaves of them.
    pub fn reduce(&self, x: &mut [T]) {
        self.all_forward(x, &self.split());
    }

    /// Replaces y by x with Lᵀ x = y; where the elimination ends before, kept entries have their answers already.
    pub fn recover(&self, x: &mut [T]) {
        self.all_backward(x, &self.split());
    }

    fn split(&self) -> Split {
        self.tree.shares(self.threads)
    }

    fn all_forward(&self, x: &mut [T], (shares, top): &Split) {
        let zeros = || vec![T::rounded(0.0); self.symbolic.nrows()];
        let spills: Vec<Vec<T>> = (self.stretches(shares, x).into_par_iter())
            .map(|mut share| {
                let (mut spill, mut product) = (zeros(), Vec::new());
                for stretch in &mut share {
                    for s in stretch.supernodes.clone() {
                        self.forward(s, stretch, &mut spill, &mut product);
                    }
                }
                spill
            })
            .collect();
        let (mut none, mut product) = (Vec::new(), Vec::new());
        let mut whole = Stretch {
            supernodes: 0..self.tree.len(),
            base: 0,
            x,
        };
        for s in top {
            for i in self.tree.begin[*s]..self.tree.begin[*s + 1] {
                spills.iter().for_each(|spill| whole.x[i] += spill[i]);
            }
            self.forward(*s, &mut whole, &mut none, &mut product);
        }
        for i in self.tree.kept() {
            spills.iter().for_each(|spill| whole.x[i] += spill[i]);
        }
    }

    fn all_backward(&self, x: &mut [T], (shares, top): &Split) {
        let (none, mut product) = (Vec::new(), Vec::new());
        let mut whole = Stretch {
            supernodes: 0..self.tree.len(),
            base: 0,
            x,
        };
        for s in top.iter().rev() {
            self.backward(*s, &mut whole, &none, &mut product);
        }
        let above = whole.x.to_vec();
        (self.stretches(shares, whole.x).into_par_iter()).for_each(|mut share| {
            let mut product = Vec::new();
            for stretch in &mut share {
                for s in stretch.supernodes.clone().rev() {
                    self.backward(s, stretch, &above, &mut product);
                }
            }
        });
    }

    /// The stretches of the subtrees of each share.
    fn stretches<'x>(&self, shares: &[Vec<usize>], x: &'x mut [T]) -> Vec<Vec<Stretch<'x, T>>> {
        let roots = shares.iter().enumerate();
        let mut roots: Vec<(usize, usize)> = roots
            .flat_map(|(share, roots)| roots.iter().map(move |root| (*root, share)))
            .collect();
        roots.sort_unstable();
        let mut made: Vec<_> = shares.iter().map(|_| Vec::new()).collect();
        let (mut rest, mut at) = (x, 0);
        for (root, share) in roots {
            let supernodes = self.tree.first[root]..root + 1;
            let [base, end] = [supernodes.start, supernodes.end].map(|s| self.tree.begin[s]);
            let (own, tail) = rest.split_at_mut(base - at).1.split_at_mut(end - base);
            made[share].push(Stretch {
                supernodes,
                base,
                x: own,
            });
            (rest, at) = (tail, end);
        }
        made
    }

    /// Triangle and rectangle of a supernode, and the rows of the rectangle.
    pub(super) fn block(&self, s: usize) -> (MatRef<'_, T>, MatRef<'_, T>, &[u32]) {
        let (rows, width) = (self.tree.rows(self.symbolic, s), self.tree.columns(s));
        let values = &self.values[self.tree.value[s]..self.tree.value[s + 1]];
        let block = MatRef::from_column_major_slice(values, width + rows.len(), width);
        let (triangle, rectangle) = block.split_at_row(width);
        (triangle, rectangle, rows)
    }

    /// Solves with the triangle of a supernode. What that takes off rows beyond the stretch is added to `spill`.
    fn forward(&self, s: usize, to: &mut Stretch<T>, spill: &mut [T], product: &mut Vec<T>) {
        let (triangle, rectangle, rows) = self.block(s);
        let from = self.tree.begin[s] - to.base;
        let own = &mut to.x[from..from + triangle.ncols()];
        let mut own = MatMut::from_column_major_slice_mut(own, triangle.ncols(), 1);
        solve_lower_triangular_in_place(triangle, own.rb_mut(), Par::Seq);
        product.resize(rows.len(), T::rounded(0.0));
        let out = MatMut::from_column_major_slice_mut(product, rows.len(), 1);
        let minus = T::rounded(-1.0);
        matmul(out, Accum::Replace, rectangle, own.rb(), minus, Par::Seq);
        for (row, value) in rows.iter().map(|r| *r as usize).zip(product) {
            match to.x.get_mut(row - to.base) {
                Some(x) => *x += *value,
                None => spill[row] += *value,
            }
        }
    }

    /// Solves with the transposed triangle of a supernode; `above` has the answers beyond the stretch.
    fn backward(&self, s: usize, to: &mut Stretch<T>, above: &[T], product: &mut Vec<T>) {
        let (triangle, rectangle, rows) = self.block(s);
        product.clear();
        let answer = |row: usize| {
            to.x.get(row - to.base)
                .copied()
                .unwrap_or_else(|| above[row])
        };
        product.extend(rows.iter().map(|r| answer(*r as usize)));
        let from = self.tree.begin[s] - to.base;
        let own = &mut to.x[from..from + triangle.ncols()];
        let mut own = MatMut::from_column_major_slice_mut(own, triangle.ncols(), 1);
        let known = MatRef::from_column_major_slice(product, rows.len(), 1);
        let minus = T::rounded(-1.0);
        matmul(
            own.rb_mut(),
            Accum::Add,
            rectangle.transpose(),
            known,
            minus,
            Par::Seq,
        );
        solve_upper_triangular_in_place(triangle.transpose(), own, Par::Seq);
    }
}
