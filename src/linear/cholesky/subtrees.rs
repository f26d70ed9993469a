//! The numeric factor, subtrees of the elimination tree side by side.
//!
//! faer's threads split every product, and most products are too small for that: two threads take
//! longer than one. Here each thread factors whole subtrees by itself, and only what is left above
//! them is split. Left-looking, supernode by supernode (Ng and Peyton 1993), into faer's storage.

use super::{FactorError, not_positive};
use crate::linear::sparse::{Pattern, SymmetricMatrix};
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

/// The elimination tree of supernodes.
pub struct Tree<'s> {
    symbolic: &'s SymbolicSupernodalCholesky<u32>,
    /// First column of each supernode, and the number of columns.
    begin: Vec<usize>,
    /// First value of each supernode, and the number of values.
    value: Vec<usize>,
    /// Supernodes that update each supernode.
    sources: Vec<Vec<u32>>,
    children: Vec<Vec<usize>>,
    roots: Vec<usize>,
    /// First supernode of the subtree below each, the number of supernodes and the work in it.
    first: Vec<usize>,
    size: Vec<usize>,
    work: Vec<f64>,
}

/// The matrix in the order of the factor: of each column its rows, and where its values are.
struct Input<'m> {
    columns: Vec<usize>,
    rows: Vec<u32>,
    places: Vec<u32>,
    values: &'m [f64],
}

/// A pivot that is not positive, in the order of the factor.
struct Pivot(usize);

/// Factors `matrix`, the equations of which are eliminated in `order`, into `values`.
///
/// # Errors
/// [`FactorError::NotPositiveDefinite`].
pub fn factorise(
    symbolic: &SymbolicSupernodalCholesky<u32>,
    order: &[u32],
    pattern: &Pattern,
    matrix: &SymmetricMatrix,
    values: &mut [f64],
) -> Result<(), FactorError> {
    let tree = Tree::new(symbolic);
    let input = Input::new(pattern, matrix, order);
    let result = tree.factorise(&input, values, rayon::current_num_threads());
    result.map_err(|Pivot(k)| not_positive(order, k))
}

impl<'s> Tree<'s> {
    fn new(symbolic: &'s SymbolicSupernodalCholesky<u32>) -> Self {
        let count = symbolic.n_supernodes();
        let mut begin: Vec<usize> = (symbolic.supernode_begin().iter().take(count))
            .map(|b| *b as usize)
            .collect();
        begin.push(symbolic.nrows());
        let mut owner = vec![0u32; symbolic.nrows()];
        for (s, ends) in begin.windows(2).enumerate() {
            owner[ends[0]..ends[1]].fill(s as u32);
        }
        let mut tree = Self {
            value: symbolic
                .col_ptr_for_val()
                .iter()
                .map(|v| *v as usize)
                .collect(),
            sources: vec![Vec::new(); count],
            children: vec![Vec::new(); count],
            roots: Vec::new(),
            first: (0..count).collect(),
            size: vec![1; count],
            work: vec![0.0; count],
            symbolic,
            begin,
        };
        for s in 0..count {
            let rows = tree.rows(s);
            let mut last = u32::MAX;
            for above in rows.iter().map(|r| owner[*r as usize]) {
                if above != last {
                    tree.sources[above as usize].push(s as u32);
                    last = above;
                }
            }
            let columns = tree.begin[s + 1] - tree.begin[s];
            let height = columns + rows.len();
            let own: f64 = (0..columns).map(|c| ((height - c) as f64).powi(2)).sum();
            tree.work[s] += own;
            let Some(parent) = rows.first().map(|r| owner[*r as usize] as usize) else {
                tree.roots.push(s);
                continue;
            };
            tree.children[parent].push(s);
            tree.work[parent] += tree.work[s];
            tree.size[parent] += tree.size[s];
            tree.first[parent] = tree.first[parent].min(tree.first[s]);
        }
        tree
    }

    /// Rows below the columns of a supernode.
    fn rows(&self, s: usize) -> &'s [u32] {
        self.symbolic.supernode(s).pattern()
    }

    fn factorise(&self, input: &Input, values: &mut [f64], threads: usize) -> Result<(), Pivot> {
        let (subtrees, top) = self.split(threads);
        let mut parts = Vec::new();
        let (mut rest, mut at) = (&mut *values, 0);
        for root in subtrees {
            let (from, to) = (self.value[self.first[root]], self.value[root + 1]);
            let (_, tail) = rest.split_at_mut(from - at);
            let (own, tail) = tail.split_at_mut(to - from);
            parts.push((root, own));
            (rest, at) = (tail, to);
        }
        // The heaviest first, each to the next thread that is free.
        parts.sort_by(|a, b| self.work[b.0].total_cmp(&self.work[a.0]));
        let queue = Mutex::new(parts.into_iter());
        (0..threads)
            .into_par_iter()
            .with_max_len(1)
            .try_for_each(|_| {
                let mut scratch = Scratch::new(input.len());
                loop {
                    let next = queue.lock().unwrap_or_else(|p| p.into_inner()).next();
                    let Some((root, own)) = next else {
                        return Ok(());
                    };
                    self.subtree(input, self.first[root]..root + 1, own, &mut scratch)?;
                }
            })?;
        let mut scratch = Scratch::new(input.len());
        for s in top {
            self.above(input, s, values, &mut scratch, threads)?;
        }
        Ok(())
    }

    /// Do the supernodes of the subtree follow each other?
    fn is_run(&self, root: usize) -> bool {
        self.first[root] + self.size[root] == root + 1
    }

    /// Roots of the subtrees that threads factor by themselves, and what is above them, both
    /// ascending: the heaviest is opened until the threads have about the same to do.
    fn split(&self, threads: usize) -> (Vec<usize>, Vec<usize>) {
        const UNEVEN: f64 = 0.005;
        let sum = |list: &[usize]| list.iter().map(|s| self.work[*s]).sum::<f64>();
        let total = sum(&self.roots);
        let (mut subtrees, mut top): (Vec<usize>, Vec<usize>) = (self.roots.clone(), Vec::new());
        loop {
            subtrees.sort_by(|a, b| self.work[*b].total_cmp(&self.work[*a]));
            let mut loads = vec![0.0f64; threads];
            for s in &subtrees {
                let least = loads.iter_mut().min_by(|a, b| a.total_cmp(b));
                least.into_iter().for_each(|load| *load += self.work[*s]);
            }
            let most = loads.into_iter().fold(0.0, f64::max);
            let even = most - sum(&subtrees) / threads as f64 <= UNEVEN * total;
            let opened = match subtrees.iter().position(|s| !self.is_run(*s)) {
                Some(scattered) => scattered,
                None if even => break,
                None => 0,
            };
            let opened = subtrees.remove(opened);
            subtrees.extend(&self.children[opened]);
            top.push(opened);
        }
        subtrees.sort_unstable();
        top.sort_unstable();
        (subtrees, top)
    }

    /// Supernodes of a subtree; `values` are theirs.
    fn subtree(
        &self,
        input: &Input,
        supernodes: Range<usize>,
        values: &mut [f64],
        scratch: &mut Scratch,
    ) -> Result<(), Pivot> {
        let base = self.value[supernodes.start];
        for s in supernodes {
            let (below, tail) = values.split_at_mut(self.value[s] - base);
            let own = &mut tail[..self.value[s + 1] - self.value[s]];
            let mut block = self.scatter(input, s, own, &mut scratch.local);
            let Scratch { local, product } = scratch;
            self.update(below, base, block.rb_mut(), s, 0, local, product);
            self.finish(block, s, Par::Seq)?;
        }
        Ok(())
    }

    /// A supernode above the subtrees, all threads on it.
    fn above(
        &self,
        input: &Input,
        s: usize,
        values: &mut [f64],
        scratch: &mut Scratch,
        threads: usize,
    ) -> Result<(), Pivot> {
        // Columns that are worth a task.
        const SHARE: usize = 48;
        const LARGE: f64 = 1e7;
        let (below, tail) = values.split_at_mut(self.value[s]);
        let own = &mut tail[..self.value[s + 1] - self.value[s]];
        let mut block = self.scatter(input, s, own, &mut scratch.local);
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
    fn scatter<'v>(
        &self,
        input: &Input,
        s: usize,
        values: &'v mut [f64],
        local: &mut [u32],
    ) -> MatMut<'v, f64> {
        let (begin, end) = (self.begin[s], self.begin[s + 1]);
        let rows = self.rows(s);
        let height = end - begin + rows.len();
        for (i, row) in (begin as u32..end as u32)
            .chain(rows.iter().copied())
            .enumerate()
        {
            local[row as usize] = i as u32;
        }
        values.fill(0.0);
        for (column, own) in (begin..end).zip(values.chunks_exact_mut(height)) {
            let range = input.columns[column]..input.columns[column + 1];
            for (row, place) in input.rows[range.clone()].iter().zip(&input.places[range]) {
                own[local[*row as usize] as usize] += input.values[*place as usize];
            }
        }
        MatMut::from_column_major_slice_mut(values, height, end - begin)
    }

    /// Takes off the columns from `at` on of supernode `s` what the supernodes `below` it, whose
    /// values begin with the one numbered `base`, contribute.
    #[allow(clippy::too_many_arguments)]
    fn update(
        &self,
        below: &[f64],
        base: usize,
        mut block: MatMut<f64>,
        s: usize,
        at: usize,
        local: &[u32],
        product: &mut Vec<f64>,
    ) {
        let begin = self.begin[s];
        let (low, high) = (begin + at, begin + at + block.ncols());
        for d in self.sources[s].iter().map(|d| *d as usize) {
            let rows = self.rows(d);
            let a = rows.partition_point(|r| (*r as usize) < low);
            let b = a + rows[a..].partition_point(|r| (*r as usize) < high);
            if a == b {
                continue;
            }
            let width = self.begin[d + 1] - self.begin[d];
            let source = &below[self.value[d] - base..self.value[d + 1] - base];
            let source = MatRef::from_column_major_slice(source, width + rows.len(), width);
            let (count, height) = (b - a, rows.len() - a);
            let here = source.subrows(width + a, count);
            if product.len() < height * count {
                product.resize(height * count, 0.0);
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
                1.0,
                Par::Seq,
            );
            let under = source.subrows(width + b, rows.len() - b);
            matmul(
                lower,
                Accum::Replace,
                under,
                here.transpose(),
                1.0,
                Par::Seq,
            );
            for (j, from) in product[..height * count].chunks_exact(height).enumerate() {
                let column = block.rb_mut().col_mut(rows[a + j] as usize - low);
                let Some(column) = column.try_as_col_major_mut() else {
                    unreachable!("supernodes are stored by columns");
                };
                let column = column.as_slice_mut();
                for (row, value) in rows[a + j..].iter().zip(&from[j..]) {
                    column[local[*row as usize] as usize] -= value;
                }
            }
        }
    }

    /// Factors the columns of a supernode, once all updates are in.
    fn finish(&self, block: MatMut<f64>, s: usize, par: Par) -> Result<(), Pivot> {
        let columns = block.ncols();
        let (mut top, below) = block.split_at_row_mut(columns);
        let need = dense::cholesky_in_place_scratch::<f64>(columns, par, Default::default());
        let mut memory = MemBuffer::new(need);
        dense::cholesky_in_place(
            top.rb_mut(),
            Default::default(),
            par,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|dense::LltError::NonPositivePivot { index }| Pivot(self.begin[s] + index))?;
        let top = top.rb();
        let solve = |part: MatMut<f64>| {
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
struct Scratch {
    /// Position of each row in the supernode at hand.
    local: Vec<u32>,
    product: Vec<f64>,
}

impl Scratch {
    fn new(equations: usize) -> Self {
        Self {
            local: vec![0; equations],
            product: Vec::new(),
        }
    }
}

impl<'m> Input<'m> {
    fn new(pattern: &Pattern, matrix: &'m SymmetricMatrix, order: &[u32]) -> Self {
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
            values: &matrix.values,
        }
    }

    fn len(&self) -> usize {
        self.columns.len() - 1
    }
}
