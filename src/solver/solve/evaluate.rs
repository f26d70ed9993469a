//! Residual and tangent at a displacement.

use super::history::History;
use super::model::Model;
use super::rows::ContactRow;
use crate::ground::geometry::dot;
use crate::model::material::j2::{self, PlasticPoint};
use crate::solver::contact::law::{Answer, Node};
use crate::solver::fem::bbar::ElementVector;
use crate::solver::fem::element::Answer as ElementAnswer;
use crate::solver::fem::loads::at_nodes;
use crate::solver::linear::sparse::SymmetricMatrix;
use crate::solver::solve::params::ENTRIES_PER_TASK;
use rayon::prelude::*;

/// An element that yields, or has yielded before.
pub struct PlasticAnswer {
    /// Position in [`Model::yielding`].
    pub index: usize,
    pub points: Box<[PlasticPoint; 8]>,
    pub flows: [Option<j2::Flow>; 8],
    /// Force that the plastic strain takes off the elastic answer.
    relief: ElementVector,
}

impl PlasticAnswer {
    /// Does it flow, so that its stiffness changes?
    pub fn flows(&self) -> bool {
        self.flows.iter().any(Option::is_some)
    }

    /// For displacements so far off that the element has no answer: no force either, so that the
    /// step there is not taken.
    fn lost(index: usize, points: [PlasticPoint; 8]) -> Self {
        Self {
            index,
            points: Box::new(points),
            flows: [None; 8],
            relief: [[f64::NAN; 3]; 8],
        }
    }
}

/// Everything known at a trial displacement.
pub struct Evaluation {
    /// External minus internal minus contact forces.
    pub residual: Vec<f64>,
    /// Contact answers and relative displacements, row by row.
    pub contact: Vec<Answer>,
    pub relative: Vec<[f64; 3]>,
    pub plastic: Vec<PlasticAnswer>,
}

/// A trial point: the unknowns, the contact nodes, and where in the load history it is.
pub struct Trial<'t> {
    pub x: &'t [f64],
    pub nodes: &'t [Node],
    pub external: &'t [f64],
    pub step: usize,
    pub time: f64,
}

impl Model<'_> {
    /// Residual, contact and plastic answers at a trial point.
    pub fn evaluate(&self, history: &History, trial: &Trial) -> Evaluation {
        let u = self.kept_displacement(trial.x, trial.step, trial.time);
        let mut internal = vec![0.0; self.dofs.len()];
        self.pattern
            .multiply(&self.stiffness, trial.x, &mut internal);
        let plastic = self.plastic_answers(history, &u);
        let nodes = |index: usize| self.scene.mesh.hexes[self.yielding[index] as usize];
        let relief = (plastic.iter()).map(|answer| (nodes(answer.index), answer.relief));
        let mut nodal = at_nodes(u.len(), relief);
        let (contact, relative) = self.contact_answers(history, trial, &u);
        for ((row, answer), node) in self.rows.iter().zip(&contact).zip(trial.nodes) {
            if !node.closed {
                continue;
            }
            let force = row.global(&answer.traction).map(|t| t * row.row.area);
            for (node, coefficient) in &row.row.terms {
                for axis in 0..3 {
                    nodal[*node as usize][axis] -= coefficient[axis] * force[axis];
                }
            }
        }
        let mut residual = self.dofs.gather(&nodal);
        for ((r, external), internal) in residual.iter_mut().zip(trial.external).zip(internal) {
            *r += external - internal;
        }
        Evaluation {
            residual,
            contact,
            relative,
            plastic,
        }
    }

    fn plastic_answers(&self, history: &History, u: &[[f64; 3]]) -> Vec<PlasticAnswer> {
        let mesh = &self.scene.mesh;
        self.yielding
            .par_iter()
            .enumerate()
            .filter_map(|(index, &element)| {
                let nodes = mesh.hexes[element as usize];
                let local = nodes.map(|n| u[n as usize]);
                let body = mesh.body_of(element as usize);
                let (steel, elastic) = (&self.scene.materials[body], &self.elastic[body]);
                let shape = self.element(element);
                let old = history.plastic[index].as_deref();
                let start = old.copied().unwrap_or_default();
                let Some(answer) = shape.answer(steel, elastic, &local, &start) else {
                    return Some(PlasticAnswer::lost(index, start));
                };
                let ElementAnswer { points, flows } = answer;
                if old.is_none() && flows.iter().all(Option::is_none) {
                    return None;
                }
                Some(PlasticAnswer {
                    index,
                    relief: shape.relief(elastic, &points),
                    points: Box::new(points),
                    flows,
                })
            })
            .collect()
    }

    fn contact_answers(
        &self,
        history: &History,
        trial: &Trial,
        u: &[[f64; 3]],
    ) -> (Vec<Answer>, Vec<[f64; 3]>) {
        self.rows
            .par_iter()
            .enumerate()
            .map(|(index, row)| {
                let d = row.relative(u);
                let origin = history.slip_origin[index];
                let measured = [d[0] - row.row.gap, d[1] - origin[0], d[2] - origin[1]];
                (row.law.traction(&trial.nodes[index], &measured), measured)
            })
            .unzip()
    }

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
                (self.element_equations(element), change)
            })
            .collect();
        for (equations, change) in changes {
            self.pattern
                .add_block(&mut matrix, &equations, |i, j| change[i][j]);
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
    /// Local components (normal, two tangents) as a vector.
    pub fn global(&self, local: &[f64; 3]) -> [f64; 3] {
        let pressure = self.row.normal.map(|n| local[0] * n);
        let Some([s, t]) = self.row.tangents else {
            return pressure;
        };
        std::array::from_fn(|i| pressure[i] + local[1] * s[i] + local[2] * t[i])
    }

    /// Relative displacement of the two sides at the row, in local components; without friction
    /// only the first is sought.
    pub fn relative(&self, u: &[[f64; 3]]) -> [f64; 3] {
        self.relative_of(|node, axis| u[node][axis])
    }

    /// The same of the displacement that `u` has for a node and an axis.
    pub fn relative_of(&self, u: impl Fn(usize, usize) -> f64) -> [f64; 3] {
        let mut d = [0.0; 3];
        for (node, coefficient) in &self.row.terms {
            for axis in 0..3 {
                d[axis] += coefficient[axis] * u(*node as usize, axis);
            }
        }
        self.local(d)
    }

    /// A vector in local components (normal, two tangents).
    pub fn local(&self, d: [f64; 3]) -> [f64; 3] {
        let [s, t] = (self.row.tangents).map_or([0.0; 2], |tangents| tangents.map(|t| dot(d, t)));
        [dot(d, self.row.normal), s, t]
    }

    /// Adds area · Cᵀ E C with the law's tangent E.
    fn add_stiffness(&self, model: &Model, answer: &Answer, matrix: &mut SymmetricMatrix) {
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
        let equations: Vec<u32> = terms
            .iter()
            .flat_map(|(n, _)| model.dofs.equations[*n as usize])
            .collect();
        model.pattern.add_block(matrix, &equations, |i, j| {
            terms[i / 3].1[i % 3] * terms[j / 3].1[j % 3] * global[i % 3][j % 3]
        });
    }
}
