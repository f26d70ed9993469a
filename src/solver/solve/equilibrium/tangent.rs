//! The tangent matrix: elastic bodies, changed by what flows, and closed contact rows.

use crate::solver::contact::law::NodeResponse;
use crate::solver::linear::sparse::{ENTRIES_PER_TASK, SymmetricMatrix};
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::rows::contact_row::ContactRow;
use rayon::prelude::*;

impl Model<'_> {
    /// The tangent, in the place of another: bodies with what flows, closed contact nodes.
    pub fn tangent(&self, evaluation: &Evaluation, mut matrix: SymmetricMatrix) -> SymmetricMatrix {
        matrix.values.resize(self.stiffness.values.len(), 0.0);
        let shares = matrix.values.par_chunks_mut(ENTRIES_PER_TASK);
        shares
            .zip(self.stiffness.values.par_chunks(ENTRIES_PER_TASK))
            .for_each(|(to, from)| to.copy_from_slice(from));
        let changes: Vec<_> = evaluation
            .plastic
            .par_iter()
            .filter(|answer| answer.flows())
            .map(|answer| {
                let element = self.yielding[answer.index];
                let body = self.scene.mesh.body_of(element as usize);
                let shape = self.element(element);
                let change = Box::new(shape.tangent_change(&self.elastic[body], &answer.flows));
                (element, change)
            })
            .collect();
        for (element, change) in changes {
            let terms = self.element_terms(element);
            terms.add(&self.pattern, &mut matrix, &change);
        }
        for (row, answer) in self.rows.iter().zip(&evaluation.contact) {
            if answer.tangent[0][0] != 0.0 {
                row.add_stiffness(self, answer, &mut matrix);
            }
        }
        matrix
    }
}

impl ContactRow {
    /// Adds area · Cᵀ E C with the law's tangent E.
    fn add_stiffness(&self, model: &Model, answer: &NodeResponse, matrix: &mut SymmetricMatrix) {
        let (n, e) = (self.row.normal, &answer.tangent);
        let mut global = n.map(|i| n.map(|j| e[0][0] * i * j));
        if let Some(frame) = self.row.tangents {
            for a in 0..2 {
                for b in 0..2 {
                    for i in 0..3 {
                        for j in 0..3 {
                            global[i][j] += e[1 + a][1 + b] * frame[a][i] * frame[b][j];
                        }
                    }
                }
            }
        }
        let global = global.map(|row| row.map(|v| self.row.area * v));
        let terms = &self.row.terms;
        let equations = terms
            .iter()
            .flat_map(|(n, _)| model.dofs.equations[*n as usize]);
        let further = self.further(&model.dofs);
        if further.is_empty() {
            let equations: Vec<u32> = equations.collect();
            model.pattern.add_block(matrix, &equations, |i, j| {
                terms[i / 3].1[i % 3] * terms[j / 3].1[j % 3] * global[i % 3][j % 3]
            });
            return;
        }
        let equations: Vec<u32> = equations.chain(further.iter().map(|f| f.0)).collect();
        let own = (0..3 * terms.len()).map(|i| (i % 3, terms[i / 3].1[i % 3]));
        let shares: Vec<(usize, f64)> = own.chain(further.iter().map(|f| (f.1, f.2))).collect();
        model.pattern.add_block(matrix, &equations, |i, j| {
            let ((a, u), (b, v)) = (shares[i], shares[j]);
            u * v * global[a][b]
        });
    }
}
