//! One supernode of a Cholesky factor: its entries, the updates from below, its dense factor.

use super::entries::Entries;
use super::number::Number;
use super::tree::Tree;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor as dense;
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{Accum, MatMut, MatRef, Par};

/// A factorisation under way.
pub(super) struct Work<'a, T> {
    /// Structure of the factor.
    pub symbolic: &'a SymbolicSupernodalCholesky<u32>,
    /// Who updates whom.
    pub tree: &'a Tree,
    /// Where the entries of the matrix go.
    pub entries: &'a Entries,
    /// Entries of the matrix, in the order of its pattern.
    pub values: &'a [T],
}

/// The position, in the order of elimination, of a pivot that is not positive.
pub(super) struct Pivot(pub usize);

impl<'a, T: Number> Work<'a, T> {
    /// Rows of a supernode below its triangle, ascending, in the order of elimination.
    fn rows(&self, s: usize) -> &'a [u32] {
        self.tree.rows(self.symbolic, s)
    }

    /// Puts the entries of the matrix in a supernode. `local` then holds, of each row of the supernode, its position in
    /// the block; what it holds of other rows is of no meaning.
    pub fn scatter<'v>(&self, s: usize, values: &'v mut [T], local: &mut [u32]) -> MatMut<'v, T> {
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
        for (column, own) in (begin..end).zip(values.chunks_exact_mut(height.max(1))) {
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
    pub fn update(
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
            let width = self.tree.columns(d);
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
    pub fn finish(&self, block: MatMut<T>, s: usize, par: Par) -> Result<(), Pivot> {
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
pub(super) struct Scratch<T> {
    /// Position of each row in the block of the supernode at hand.
    pub local: Vec<u32>,
    /// The product of an update.
    pub product: Vec<T>,
}

impl<T> Scratch<T> {
    /// For a matrix of so many equations.
    pub fn new(equations: usize) -> Self {
        Self {
            local: vec![0; equations],
            product: Vec::new(),
        }
    }
}
