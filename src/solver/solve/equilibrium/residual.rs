//! The residual at a trial displacement.
//!
//! r = f_ext − K u + Σ f_p − Σ_rows area · Cᵀ t: external forces, less those of elastic bodies, with what the plastic
//! strain of yielding elements takes off them, less the contact tractions t on both sides of each closed row.

use crate::model::material::j2::PlasticPoint;
use crate::solver::contact::law::NodeResponse;
use crate::solver::fem::element::ElementResponse;
use crate::solver::fem::loads::at_nodes;
use crate::solver::solve::equilibrium::evaluation::{Evaluation, PlasticAnswer, Trial};
use crate::solver::solve::equilibrium::history::History;
use crate::solver::solve::model::system::Model;
use rayon::prelude::*;

impl Model<'_> {
    /// Residual, contact and plastic answers at a trial point.
    pub fn evaluate(&self, history: &History, trial: &Trial) -> Evaluation {
        let u = self.kept_displacement(trial.x, trial.step, trial.time);
        let mut internal = vec![0.0; self.dofs.len()];
        self.pattern
            .multiply(&self.stiffness, trial.x, &mut internal);
        let plastic = self.plastic_answers(history, trial, &u);
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

    fn plastic_answers(
        &self,
        history: &History,
        trial: &Trial,
        u: &[[f64; 3]],
    ) -> Vec<PlasticAnswer> {
        let moment = (trial.step, trial.time);
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
                if !trial.flows {
                    let relief = shape.relief(elastic, old?);
                    return Some(PlasticAnswer::at_rest(index, *old?, relief));
                }
                let start = old.copied().unwrap_or_default();
                let free = self.free_strains(element, start, moment);
                let Some(answer) = shape.answer(steel, elastic, &local, &free) else {
                    return Some(PlasticAnswer::lost(index, start));
                };
                let ElementResponse { mut points, flows } = answer;
                if !self.heated.is_empty() {
                    plastic_alone(&mut points, (&free, &start));
                }
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
    ) -> (Vec<NodeResponse>, Vec<[f64; 3]>) {
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
}

/// Takes the thermal strain off again: the histories go from `free`, which has it, back to what they were with `start`.
fn plastic_alone(
    points: &mut [PlasticPoint; 8],
    (free, start): (&[PlasticPoint; 8], &[PlasticPoint; 8]),
) {
    for (point, (free, start)) in points.iter_mut().zip(free.iter().zip(start)) {
        let ends = point.strain.iter_mut().zip(&free.strain).zip(&start.strain);
        ends.for_each(|((end, free), start)| *end = start + (*end - free));
    }
}
