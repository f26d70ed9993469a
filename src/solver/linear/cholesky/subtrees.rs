//! The numeric Cholesky factor on several threads: subtrees of the elimination tree side by side.
//!
//! Words (Liu, SIAM J. Matrix Anal. Appl. 11 (1990) 134; Ng and Peyton, SIAM J. Sci. Comput. 14 (1993) 1034):
//!
//! - A *supernode* is a run of columns of L with the same rows below them. It is stored as one dense block, column by
//!   column: a triangle at the top, a rectangle below.
//! - Supernode d *updates* supernode s where a row below d is a column of s. The parent of d in the *elimination
//!   tree* is the first supernode that it updates; all others that it updates are further up on the way to the root.
//!   So two supernodes of which neither is above the other have nothing to do with each other.
//!
//! The factor is made *left-looking*: when its turn comes, a supernode first takes all updates of those below it
//!
//! ```text
//! A_s ← A_s − Σ_d L_d(rows from s on) · L_d(rows that are columns of s)ᵀ
//! ```
//!
//! and is then factored as a dense block: Cholesky of the triangle, triangular solve for the rectangle.
//!
//! faer's threads split each of these products, and most are too small for that: two threads take longer than one.
//! Here the tree is cut into subtrees of about equal work (`Tree::split`; Geist and Ng, Int. J. Parallel
//! Programming 18 (1989) 291). Each is factored by one thread alone, and only the few large supernodes above them
//! are worked on by all threads. The updates of an entry come in the same
//! order on any number of threads; only the dense factors of the large supernodes may round differently.

use super::entries::Entries;
use super::number::Number;
use super::supernode::{Pivot, Scratch, Work};
use super::tree::Tree;
use super::triangles::Triangles;
use crate::solver::linear::sparse::Pattern;
use faer::prelude::ReborrowMut;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{MatMut, Par};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Mutex;

/// What is known of the work before any number: the elimination tree, and where the entries of the matrix go.
pub struct Plan {
    tree: Tree,
    entries: Entries,
}

impl Plan {
    /// For a pattern whose equations are eliminated in `order`, the first `eliminated` of them.
    pub fn new(
        symbolic: &SymbolicSupernodalCholesky<u32>,
        pattern: &Pattern,
        (order, eliminated): (&[u32], usize),
    ) -> Self {
        Self {
            tree: Tree::new(symbolic, eliminated),
            entries: Entries::new(pattern, order),
        }
    }

    /// Factors the matrix of these `entries` into `values`.
    ///
    /// # Errors
    /// A [`Pivot`] that is not positive.
    pub(super) fn factorise<T: Number>(
        &self,
        symbolic: &SymbolicSupernodalCholesky<u32>,
        entries: &[T],
        values: &mut [T],
    ) -> Result<(), Pivot> {
        self.work(symbolic, entries)
            .factorise(values, rayon::current_num_threads())
    }

    /// What the elimination with a factor of these `values` leaves of the kept columns: the lower triangle, column by
    /// column.
    pub(super) fn complement<T: Number>(
        &self,
        symbolic: &SymbolicSupernodalCholesky<u32>,
        entries: &[T],
        values: &[T],
    ) -> Vec<T> {
        self.work(symbolic, entries)
            .complement(values, rayon::current_num_threads())
    }

    fn work<'a, T>(
        &'a self,
        symbolic: &'a SymbolicSupernodalCholesky<u32>,
        values: &'a [T],
    ) -> Work<'a, T> {
        Work {
            symbolic,
            tree: &self.tree,
            entries: &self.entries,
            values,
        }
    }

    /// Number of values of the factor.
    pub(super) fn values(&self) -> usize {
        self.tree.value[self.tree.len()]
    }

    /// The tree alone, to solve with.
    pub(super) fn into_tree(self) -> Tree {
        self.tree
    }

    /// The factor of these `values`, to solve with on so many `threads`.
    pub(super) fn triangles<'a, T: Number>(
        &'a self,
        symbolic: &'a SymbolicSupernodalCholesky<u32>,
        (values, threads): (&'a [T], usize),
    ) -> Triangles<'a, T> {
        Triangles {
            symbolic,
            tree: &self.tree,
            values,
            threads,
        }
    }
}

impl<T: Number> Work<'_, T> {
    /// Factors all: subtrees first, then what is above them.
    fn factorise(&self, values: &mut [T], threads: usize) -> Result<(), Pivot> {
        let (subtrees, top) = self.tree.split(threads);
        // The values of a subtree follow each other: each thread gets a slice of its own.
        let mut parts = Vec::new();
        let (mut rest, mut at) = (&mut *values, 0);
        for root in subtrees {
            let (from, to) = (
                self.tree.value[self.tree.first[root]],
                self.tree.value[root + 1],
            );
            let (_, tail) = rest.split_at_mut(from - at);
            let (own, tail) = tail.split_at_mut(to - from);
            parts.push((root, own));
            (rest, at) = (tail, to);
        }
        // The heaviest first, each to the next thread that is free: the light ones at the end even out.
        parts.sort_by(|a, b| self.tree.work[b.0].total_cmp(&self.tree.work[a.0]));
        let queue = Mutex::new(parts.into_iter());
        // The first bad pivot of all subtrees, whichever thread finds one first.
        let bad = (0..threads).into_par_iter().with_max_len(1).map(|_| {
            let mut scratch = Scratch::new(self.entries.len());
            let mut bad = None;
            loop {
                let next = queue.lock().unwrap_or_else(|p| p.into_inner()).next();
                let Some((root, own)) = next else {
                    return bad;
                };
                let supernodes = self.tree.first[root]..root + 1;
                if let Err(Pivot(found)) = self.subtree(supernodes, own, &mut scratch) {
                    bad = Some(bad.map_or(found, |bad: usize| bad.min(found)));
                }
            }
        });
        if let Some(bad) = bad.flatten().min() {
            return Err(Pivot(bad));
        }
        let mut scratch = Scratch::new(self.entries.len());
        for s in top {
            self.above(s, values, &mut scratch, threads)?;
        }
        Ok(())
    }

    /// Factors the supernodes of a subtree, whose `values` these are, on one thread.
    fn subtree(
        &self,
        supernodes: Range<usize>,
        values: &mut [T],
        scratch: &mut Scratch<T>,
    ) -> Result<(), Pivot> {
        let base = self.tree.value[supernodes.start];
        for s in supernodes {
            let (below, tail) = values.split_at_mut(self.tree.value[s] - base);
            let own = &mut tail[..self.tree.value[s + 1] - self.tree.value[s]];
            let mut block = self.scatter(s, own, &mut scratch.local);
            let Scratch { local, product } = scratch;
            self.update(below, base, block.rb_mut(), s, 0, local, product);
            self.finish(block, s, Par::Seq)?;
        }
        Ok(())
    }

    /// Factors a supernode above the subtrees, all threads on it.
    fn above(
        &self,
        s: usize,
        values: &mut [T],
        scratch: &mut Scratch<T>,
        threads: usize,
    ) -> Result<(), Pivot> {
        /// Multiplications of the dense factor from which on faer's threads pay.
        const LEAST_WORK_FOR_THREADS: f64 = 1e7;
        let (below, tail) = values.split_at_mut(self.tree.value[s]);
        let own = &mut tail[..self.tree.value[s + 1] - self.tree.value[s]];
        let block = self.gather(s, below, own, scratch, threads);
        let columns = block.ncols();
        let own: f64 = columns as f64 * (block.nrows() as f64).powi(2);
        let par = if own > LEAST_WORK_FOR_THREADS {
            Par::rayon(threads)
        } else {
            Par::Seq
        };
        self.finish(block, s, par)
    }

    /// See [`Plan::complement`].
    fn complement(&self, values: &[T], threads: usize) -> Vec<T> {
        let s = self.tree.len();
        let mut kept = vec![T::rounded(0.0); self.tree.columns(s).pow(2)];
        let mut scratch = Scratch::new(self.entries.len());
        self.gather(s, values, &mut kept, &mut scratch, threads);
        kept
    }

    /// Entries of a supernode less all updates, made by all threads: each takes the updates of a stretch of columns.
    fn gather<'v>(
        &self,
        s: usize,
        below: &[T],
        own: &'v mut [T],
        scratch: &mut Scratch<T>,
        threads: usize,
    ) -> MatMut<'v, T> {
        /// Columns that are worth a task of their own.
        const COLUMNS_PER_TASK: usize = 48;
        let mut block = self.scatter(s, own, &mut scratch.local);
        let columns = block.ncols();
        let tasks = (columns / COLUMNS_PER_TASK).clamp(1, 4 * threads);
        let mut parts = Vec::new();
        let (mut rest, mut at) = (block.rb_mut(), 0);
        for k in 1..=tasks {
            let end = columns * k / tasks;
            let (own, tail) = rest.split_at_col_mut(end - at);
            parts.push((at, own));
            (rest, at) = (tail, end);
        }
        let local = &scratch.local;
        (parts.into_par_iter().with_max_len(1)).for_each_init(Vec::new, |product, (at, part)| {
            self.update(below, 0, part, s, at, local, product);
        });
        block
    }
}
