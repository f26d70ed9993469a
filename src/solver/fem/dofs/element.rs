//! How the components of an element hang on equations.

use super::fixed::FIXED;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};

/// Equations of the 24 components of an element.
pub struct ElementTerms {
    /// The equation of each component, or [`FIXED`].
    pub equations: [u32; 24],
    /// 1, or −1 where a component moves against its equation.
    pub signs: [f64; 24],
    /// Further shares, of turns of rigid planes and of ties: component, equation, lever.
    pub further: Vec<(usize, u32, f64)>,
}

impl ElementTerms {
    /// All equations, those of turns included, [`FIXED`] for none.
    pub fn all(self) -> impl Iterator<Item = u32> {
        let further = self.further.into_iter().map(|(_, equation, _)| equation);
        self.equations.into_iter().chain(further)
    }

    /// With the equations numbered by `number`, which is asked for none that is [`FIXED`].
    pub fn renumbered(mut self, number: impl Fn(u32) -> u32) -> Self {
        let further = self.further.iter_mut().map(|(_, equation, _)| equation);
        let all = self.equations.iter_mut().chain(further);
        all.filter(|e| **e != FIXED).for_each(|e| *e = number(*e));
        self
    }

    /// Adds the element's matrix to `matrix`.
    pub fn add(&self, pattern: &Pattern, matrix: &mut SymmetricMatrix, block: &[[f64; 24]; 24]) {
        let sign = &self.signs;
        if self.further.is_empty() {
            pattern.add_block(matrix, &self.equations, |i, j| {
                sign[i] * sign[j] * block[i][j]
            });
            return;
        }
        let further = self.further.iter().map(|(_, equation, _)| *equation);
        let equations: Vec<u32> = self.equations.into_iter().chain(further).collect();
        let own = (0..24).map(|k| (k, sign[k]));
        let further = self.further.iter().map(|(k, _, lever)| (*k, *lever));
        let terms: Vec<(usize, f64)> = own.chain(further).collect();
        pattern.add_block(matrix, &equations, |i, j| {
            let ((a, u), (b, v)) = (terms[i], terms[j]);
            u * v * block[a][b]
        });
    }
}
