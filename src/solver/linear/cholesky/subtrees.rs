//! The numeric factor, subtrees of the elimination tree side by side.
//!
//! faer's threads split every product, and most products are too small for that: two threads take
//! longer than one. Here each thread factors whole subtrees by itself, and only what is left above
//! them is split. Left-looking, supernode by supernode (Ng and Peyton 1993), into faer's storage.

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

/// What is known of the work before any number: the elimination tree of supernodes, and where the
/// matrix's entries go.
pub struct Plan {
    tree: Tree,
    entries: Entries,
}

/// A factorisation under way.
struct Work<'a, T> {
    symbolic: &'a SymbolicSupernodalCholesky<u32>,
    tree: &'a Tree,
    entries: &'a Entries,
    /// Of the matrix.
    values: &'a [T],
}

/// A pivot that is not positive, in the order of the factor.
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
    /// Rows below the columns of a supernode.
    fn rows(&self, s: usize) -> &'a [u32] {
        self.symbolic.supernode(s).pattern()
    }

    fn factorise(&self, values: &mut [T], threads: usize) -> Result<(), Pivot> {
        let (subtrees, top) = self.tree.split(threads);
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
        // The heaviest first, each to the next thread that is free.
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

    /// Supernodes of a subtree; `values` are theirs.
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

    /// A supernode above the subtrees, all threads on it.
    fn above(
        &self,
        s: usize,
        values: &mut [T],
        scratch: &mut Scratch<T>,
        threads: usize,
    ) -> Result<(), Pivot> {
        // Columns that are worth a task.
        const SHARE: usize = 48;
        const LARGE: f64 = 1e7;
        let (below, tail) = values.split_at_mut(self.tree.value[s]);
        let own = &mut tail[..self.tree.value[s + 1] - self.tree.value[s]];
        let mut block = self.scatter(s, own, &mut scratch.local);
        let columns = block.ncols();
        let shares = (columns / SHARE).clamp(1, 4 * threads);
        let mut parts = Vec::new();
        let (mut rest, mut at) = (block.rb_mut(), 0);
        for k in 1..=shares {
            let end = columns * k / shares;
            let (own, tail) = rest.split_at_col_mut(end - at);
            parts.push((at, own));
            (rest, at) = (tail, end);
        }
        let local = &scratch.local;
        (parts.into_par_iter().with_max_len(1)).for_each_init(Vec::new, |product, (at, part)| {
            self.update(below, 0, part, s, at, local, product);
        });
        let own: f64 = columns as f64 * (block.nrows() as f64).powi(2);
        let par = if own > LARGE {
            Par::rayon(threads)
        } else {
            Par::Seq
        };
        self.finish(block, s, par)
    }

    /// The matrix's entries in a supernode; `local` then holds the position of each of its rows.
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

    /// Takes off the columns from `at` on of supernode `s` what the supernodes `below` it, whose
    /// values begin with the one numbered `base`, contribute.
    #[allow(clippy::too_many_arguments)]
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

    /// Factors the columns of a supernode, once all updates are in.
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

/// What a thread works with.
struct Scratch<T> {
    /// Position of each row in the supernode at hand.
    local: Vec<u32>,
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
