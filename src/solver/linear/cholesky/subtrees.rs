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
//! are worked on by all threads. The order of the updates of an entry does not depend on the threads.

use super::entries::Entries;
use super::number::Number;
use super::tree::Tree;
use crate::solver::linear::sparse::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor as dense;
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{Accum, MatMut, MatRef, Par};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Mutex;

/// What is known of the work before any number: the elimination tree, and where the entries of the matrix go.
pub struct Plan {
    tree: Tree,
    entries: Entries,
}

/// A factorisation under way.
struct Work<'a, T> {
    symbolic: &'a SymbolicSupernodalCholesky<u32>,
    tree: &'a Tree,
    entries: &'a Entries,
    /// Entries of the matrix, in the order of its pattern.
    values: &'a [T],
}

/// The position, in the order of elimination, of a pivot that is not positive.
pub struct Pivot(pub usize);

impl Plan {
    /// For a pattern whose equations are eliminated in `order`.
    pub fn new(
        symbolic: &SymbolicSupernodalCholesky<u32>,
        pattern: &Pattern,
        order: &[u32],
    ) -> Self {
        Self {
            tree: Tree::new(symbolic),
            entries: Entries::new(pattern, order),
        }
    }

    /// Factors the matrix of these `entries` into `values`.
    ///
    /// # Errors
    /// A [`Pivot`] that is not positive.
    pub fn factorise<T: Number>(
        &self,
        symbolic: &SymbolicSupernodalCholesky<u32>,
        entries: &[T],
        values: &mut [T],
    ) -> Result<(), Pivot> {
        let work = Work {
            symbolic,
            tree: &self.tree,
            entries: &self.entries,
            values: entries,
        };
        work.factorise(values, rayon::current_num_threads())
    }
}

impl<'a, T: Number> Work<'a, T> {
    /// Rows of a supernode below its triangle, ascending, in the order of elimination.
    fn rows(&self, s: usize) -> &'a [u32] {
        self.symbolic.supernode(s).pattern()
    }

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
        (0..threads)
            .into_par_iter()
            .with_max_len(1)
            .try_for_each(|_| {
                let mut scratch = Scratch::new(self.entries.len());
                loop {
                    let next = queue.lock().unwrap_or_else(|p| p.into_inner()).next();
                    let Some((root, own)) = next else {
                        return Ok(());
                    };
                    self.subtree(self.tree.first[root]..root + 1, own, &mut scratch)?;
                }
            })?;
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

    /// Factors a supernode above the subtrees, all threads on it: each takes the updates of a stretch of columns.
    fn above(
        &self,
        s: usize,
        values: &mut [T],
        scratch: &mut Scratch<T>,
        threads: usize,
    ) -> Result<(), Pivot> {
        /// Columns that are worth a task of their own.
        const COLUMNS_PER_TASK: usize = 48;
        /// Multiplications of the dense factor from which on faer's threads pay.
        const LEAST_WORK_FOR_THREADS: f64 = 1e7;
        let (below, tail) = values.split_at_mut(self.tree.value[s]);
        let own = &mut tail[..self.tree.value[s + 1] - self.tree.value[s]];
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
        let own: f64 = columns as f64 * (block.nrows() as f64).powi(2);
        let par = if own > LEAST_WORK_FOR_THREADS {
            Par::rayon(threads)
        } else {
            Par::Seq
        };
        self.finish(block, s, par)
    }

    /// Puts the entries of the matrix in a supernode. `local` then holds, of each row of the supernode, its position in
    /// the block; what it holds of other rows is of no meaning.
    fn scatter<'v>(&self, s: usize, values: &'v mut [T], local: &mut [u32]) -> MatMut<'v, T> {
        let (begin, end) = (self.tree.begin[s], self.tree.begin[s + 1]);
        let rows = self.rows(s);
        let height = end - begin + rows.len();
        for (i, row) in (begin as u32..end as u32)
            .chain(rows.iter().copied())
            .enumerate()
        {
            local[row as usize] = i as u32;
        }
        values.fill(T::rounded(0.0));
        for (column, own) in (begin..end).zip(values.chunks_exact_mut(height)) {
            let range = self.entries.columns[column]..self.entries.columns[column + 1];
            for (row, place) in self.entries.rows[range.clone()]
                .iter()
                .zip(&self.entries.places[range])
            {
                own[local[*row as usize] as usize] += self.values[*place as usize];
            }
        }
        MatMut::from_column_major_slice_mut(values, height, end - begin)
    }

    /// Takes all updates off `block`: the columns from `at` on of supernode `s`.
    ///
    /// `below` are values of the supernodes before it, from position `base` of all values on; `local` is that of
    /// [`Self::scatter`]. The product of each update is made in `product`, then taken off row by row, as the
    /// rows of the supernode below are some of those of `s`.
    #[expect(
        clippy::too_many_arguments,
        reason = "slices of one thread's work, each borrowed by itself"
    )]
    fn update(
        &self,
        below: &[T],
        base: usize,
        mut block: MatMut<T>,
        s: usize,
        at: usize,
        local: &[u32],
        product: &mut Vec<T>,
    ) {
        let begin = self.tree.begin[s];
        let (low, high) = (begin + at, begin + at + block.ncols());
        for d in self.tree.sources[s].iter().map(|d| *d as usize) {
            let rows = self.rows(d);
            // Rows a..b are columns of the block; rows from a on are rows of it.
            let a = rows.partition_point(|r| (*r as usize) < low);
            let b = a + rows[a..].partition_point(|r| (*r as usize) < high);
            if a == b {
                continue;
            }
            let width = self.tree.begin[d + 1] - self.tree.begin[d];
            let source = &below[self.tree.value[d] - base..self.tree.value[d + 1] - base];
            let source = MatRef::from_column_major_slice(source, width + rows.len(), width);
            let (count, height) = (b - a, rows.len() - a);
            let here = source.subrows(width + a, count);
            if product.len() < height * count {
                product.resize(height * count, T::rounded(0.0));
            }
            let out = &mut product[..height * count];
            let (upper, lower) =
                MatMut::from_column_major_slice_mut(out, height, count).split_at_row_mut(count);
            triangular::matmul(
                upper,
                BlockStructure::TriangularLower,
                Accum::Replace,
                here,
                BlockStructure::Rectangular,
                here.transpose(),
                BlockStructure::Rectangular,
                T::rounded(1.0),
                Par::Seq,
            );
            let under = source.subrows(width + b, rows.len() - b);
            matmul(
                lower,
                Accum::Replace,
                under,
                here.transpose(),
                T::rounded(1.0),
                Par::Seq,
            );
            for (j, from) in product[..height * count].chunks_exact(height).enumerate() {
                let column = block.rb_mut().col_mut(rows[a + j] as usize - low);
                let Some(column) = column.try_as_col_major_mut() else {
                    unreachable!("supernodes are stored by columns");
                };
                let column = column.as_slice_mut();
                for (row, value) in rows[a + j..].iter().zip(&from[j..]) {
                    column[local[*row as usize] as usize] -= *value;
                }
            }
        }
    }

    /// Factors a supernode as a dense block, once all updates are in.
    fn finish(&self, block: MatMut<T>, s: usize, par: Par) -> Result<(), Pivot> {
        let columns = block.ncols();
        let (mut top, below) = block.split_at_row_mut(columns);
        let need = dense::cholesky_in_place_scratch::<T>(columns, par, Default::default());
        let mut memory = MemBuffer::new(need);
        dense::cholesky_in_place(
            top.rb_mut(),
            Default::default(),
            par,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|dense::LltError::NonPositivePivot { index }| Pivot(self.tree.begin[s] + index))?;
        let top = top.rb();
        let solve = |part: MatMut<T>| {
            solve_lower_triangular_in_place(top, part.transpose_mut(), Par::Seq);
        };
        match par {
            Par::Seq => solve(below),
            _ => {
                let half = below.nrows() / 2;
                let (a, b) = below.split_at_row_mut(half);
                rayon::join(|| solve(a), || solve(b));
            }
        }
        Ok(())
    }
}

/// Memory that a thread uses again for each supernode.
struct Scratch<T> {
    /// Position of each row in the block of the supernode at hand.
    local: Vec<u32>,
    /// The product of an update.
    product: Vec<T>,
}

impl<T> Scratch<T> {
    fn new(equations: usize) -> Self {
        Self {
            local: vec![0; equations],
            product: Vec::new(),
        }
    }
}
