//! The product of a symmetric matrix with a vector, from its lower triangle.

use super::{Pattern, SymmetricMatrix};
use rayon::prelude::*;
use std::ops::Range;

impl Pattern {
    /// y = A x.
    pub fn multiply(&self, matrix: &SymmetricMatrix, x: &[f64], y: &mut [f64]) {
        /// Entries that are worth a task of their own. The cuts depend on the pattern alone, so that sums
        /// come out the same on any number of threads.
        const CHUNK: usize = 1 << 20;
        let shares = self.rows.len().div_ceil(CHUNK).clamp(1, 4);
        let vertices = self.stretch_start.len() - 1;
        let bounds: Vec<usize> = (0..=shares)
            .map(|k| {
                let entry = (self.rows.len() * k / shares) as u32;
                let begins = |start: &u32| self.columns[*start as usize] < entry;
                self.vertex_start[..vertices].partition_point(begins)
            })
            .collect();
        if shares == 1 {
            y.fill(0.0);
            return self.multiply_vertices(matrix, 0..vertices, x, y);
        }
        let parts: Vec<Vec<f64>> = (bounds.par_windows(2))
            .map(|ends| {
                let mut part = vec![0.0; y.len()];
                self.multiply_vertices(matrix, ends[0]..ends[1], x, &mut part);
                part
            })
            .collect();
        y.par_iter_mut().enumerate().for_each(|(i, y)| {
            *y = parts.iter().map(|part| part[i]).sum();
        });
    }

    /// Adds the product with the columns of `vertices` and their mirror images.
    fn multiply_vertices(
        &self,
        matrix: &SymmetricMatrix,
        vertices: Range<usize>,
        x: &[f64],
        y: &mut [f64],
    ) {
        for vertex in vertices {
            let own = self.vertex_start[vertex] as usize..self.vertex_start[vertex + 1] as usize;
            let stretches =
                self.stretch_start[vertex] as usize..self.stretch_start[vertex + 1] as usize;
            for column in own.clone() {
                let range = self.columns[column] as usize..self.columns[column + 1] as usize;
                let mut values = &matrix.values[range];
                let mut next = |count: usize| {
                    let (first, rest) = values.split_at(count);
                    values = rest;
                    first
                };
                let xc = x[column];
                let mut sum = next(1)[0] * xc;
                let within = column + 1..own.end;
                sum += add_mirrored(next(within.len()), xc, &x[within.clone()], &mut y[within]);
                for stretch in &self.stretches[stretches.clone()] {
                    let rows = stretch.start as usize..stretch.end as usize;
                    sum += add_mirrored(next(rows.len()), xc, &x[rows.clone()], &mut y[rows]);
                }
                y[column] += sum;
            }
        }
    }
}

/// Adds the product of entries below each other with `xc` to `y`; returns that of their mirror images with `x`.
fn add_mirrored(values: &[f64], xc: f64, x: &[f64], y: &mut [f64]) -> f64 {
    const LANES: usize = 8;
    let (chunks, tail) = values.as_chunks::<LANES>();
    let (x_chunks, x_tail) = x.as_chunks::<LANES>();
    let (y_chunks, y_tail) = y.as_chunks_mut::<LANES>();
    let mut sums = [0.0; LANES];
    for ((values, x), y) in chunks.iter().zip(x_chunks).zip(y_chunks) {
        for lane in 0..LANES {
            y[lane] += values[lane] * xc;
            sums[lane] += values[lane] * x[lane];
        }
    }
    let mut sum: f64 = sums.iter().sum();
    for ((value, x), y) in tail.iter().zip(x_tail).zip(y_tail) {
        *y += value * xc;
        sum += value * x;
    }
    sum
}
