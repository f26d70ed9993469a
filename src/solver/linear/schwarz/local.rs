//! One subdomain: its part of the matrix, factored in single precision.

use crate::solver::linear::cholesky::{self, FactorError};
use crate::solver::linear::ordering;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::cholesky as sparse;

/// A subdomain and the structure of its factor.
pub(super) struct Local {
    /// Equations of the subdomain, ascending.
    pub equations: Vec<u32>,
    /// Does the subdomain own the equation, or only see it?
    pub own: Vec<bool>,
    inner: sparse::SymbolicCholesky<u32>,
}

/// Its factor.
pub(super) struct LocalFactor {
    values: Vec<f32>,
    /// One over the root of the diagonal.
    scale: Vec<f32>,
}

/// Tried one after the other, added to the diagonal, which is one. A subdomain that nothing holds is singular, and single
/// precision has to see it as positive definite.
const SHIFTS: [f32; 3] = [1e-6, 1e-4, 1e-2];

impl Local {
    /// The subdomain of `vertices`, ascending.
    ///
    /// # Errors
    /// [`FactorError::Memory`].
    pub fn new(
        pattern: &Pattern,
        vertices: &[u32],
        owns: impl Fn(u32) -> bool,
    ) -> Result<Self, FactorError> {
        let starts = &pattern.vertex_start;
        let (mut equations, mut own, mut vertex_start) = (Vec::new(), Vec::new(), vec![0u32]);
        for v in vertices {
            equations.extend(starts[*v as usize]..starts[*v as usize + 1]);
            own.resize(equations.len(), owns(*v));
            vertex_start.push(equations.len() as u32);
        }
        let (columns, rows) = structure(pattern, &equations);
        let order = ordering::of_part(pattern, vertices, &vertex_start);
        let n = equations.len();
        let triangle = SymbolicSparseColMatRef::new_checked(n, n, &columns, None, &rows);
        let inner = cholesky::analyse(triangle, &order, Default::default())?;
        Ok(Self {
            equations,
            own,
            inner,
        })
    }

    /// Entries of the factor.
    pub fn factor_entries(&self) -> usize {
        self.inner.len_val()
    }

    /// Factors the subdomain's part of `matrix`.
    ///
    /// # Errors
    /// [`FactorError`] where memory runs out or the part is far from positive definite.
    pub fn factorise(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
    ) -> Result<LocalFactor, FactorError> {
        let (columns, rows) = structure(pattern, &self.equations);
        let scale: Vec<f64> = (self.equations.iter())
            .map(|e| 1.0 / matrix.values[pattern.columns[*e as usize] as usize].sqrt())
            .collect();
        let mut entries = self.entries(pattern, matrix, &columns, &rows, &scale);
        let mut values = vec![0f32; self.inner.len_val()];
        let mut result = Err(FactorError::Memory);
        for shift in SHIFTS {
            for start in &columns[..self.equations.len()] {
                entries[*start as usize] = 1.0 + shift;
            }
            result = self.numeric(&columns, &rows, &entries, &mut values);
            if result.is_ok() {
                break;
            }
        }
        result.map(|()| LocalFactor {
            values,
            scale: scale.into_iter().map(|s| s as f32).collect(),
        })
    }

    /// The part of `matrix`, scaled to a diagonal of one.
    fn entries(
        &self,
        pattern: &Pattern,
        matrix: &SymmetricMatrix,
        columns: &[u32],
        rows: &[u32],
        scale: &[f64],
    ) -> Vec<f32> {
        let mut entries = Vec::with_capacity(rows.len());
        for (j, e) in self.equations.iter().enumerate() {
            let range =
                pattern.columns[*e as usize] as usize..pattern.columns[*e as usize + 1] as usize;
            let end = columns[j + 1] as usize;
            // Both lists ascend.
            for (row, value) in pattern.rows[range.clone()]
                .iter()
                .zip(&matrix.values[range])
            {
                let next = entries.len();
                if next < end && self.equations[rows[next] as usize] == *row {
                    entries.push((value * scale[rows[next] as usize] * scale[j]) as f32);
                }
            }
        }
        entries
    }

    fn numeric(
        &self,
        columns: &[u32],
        rows: &[u32],
        entries: &[f32],
        values: &mut [f32],
    ) -> Result<(), FactorError> {
        let n = self.equations.len();
        let triangle = SymbolicSparseColMatRef::new_checked(n, n, columns, None, rows);
        cholesky::numeric_alone(&self.inner, triangle, entries, values).map_err(|error| match error
        {
            FactorError::NotPositiveDefinite { equation } => FactorError::NotPositiveDefinite {
                equation: self.equations.get(equation).map_or(0, |e| *e as usize),
            },
            FactorError::Memory => error,
        })
    }

    /// The subdomain's correction for the residual `r` of all equations.
    pub fn solve(&self, factor: &LocalFactor, r: &[f64]) -> Vec<f32> {
        let entries = self.equations.iter().zip(&factor.scale);
        let mut x: Vec<f32> = entries.map(|(e, s)| s * r[*e as usize] as f32).collect();
        cholesky::solve(&self.inner, &factor.values, &mut x);
        x.iter_mut().zip(&factor.scale).for_each(|(x, s)| *x *= s);
        x
    }
}

/// Lower triangle of the equations among each other: column starts and rows.
fn structure(pattern: &Pattern, equations: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let (mut columns, mut rows) = (vec![0u32], Vec::new());
    for (j, e) in equations.iter().enumerate() {
        let range =
            pattern.columns[*e as usize] as usize..pattern.columns[*e as usize + 1] as usize;
        let mut i = j;
        for row in &pattern.rows[range] {
            while i < equations.len() && equations[i] < *row {
                i += 1;
            }
            if i < equations.len() && equations[i] == *row {
                rows.push(i as u32);
            }
        }
        columns.push(rows.len() as u32);
    }
    (columns, rows)
}
