//! What is known at a trial displacement.

use crate::model::material::j2;
use crate::model::material::j2::PlasticPoint;
use crate::solver::contact::law::{Node, NodeResponse};
use crate::solver::fem::bbar::ElementVector;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::LIMIT_FLOW_SHARE;

/// An element that yields, or has yielded before.
pub struct PlasticAnswer {
    /// Position in [`crate::solver::solve::model::system::Model::yielding`].
    pub index: usize,
    pub points: Box<[PlasticPoint; 8]>,
    pub flows: [Option<j2::Flow>; 8],
    /// Force that the plastic strain takes off the elastic answer.
    pub relief: ElementVector,
}

impl PlasticAnswer {
    /// Does it flow, so that its stiffness changes?
    pub fn flows(&self) -> bool {
        self.flows.iter().any(Option::is_some)
    }

    /// With plastic strains that stay what they are.
    pub fn at_rest(index: usize, points: [PlasticPoint; 8], relief: ElementVector) -> Self {
        Self {
            index,
            points: Box::new(points),
            flows: [None; 8],
            relief,
        }
    }

    /// For displacements so far off that the element has no answer: no force either, so that the
    /// step there is not taken.
    pub fn lost(index: usize, points: [PlasticPoint; 8]) -> Self {
        Self::at_rest(index, points, [[f64::NAN; 3]; 8])
    }
}

/// Everything known at a trial displacement.
pub struct Evaluation {
    /// External minus internal minus contact forces.
    pub residual: Vec<f64>,
    /// Contact answers and relative displacements, row by row.
    pub contact: Vec<NodeResponse>,
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
    /// May steel flow? Else plastic strains stay what they were.
    pub flows: bool,
}

/// Integration points that flow.
pub fn flowing_points(evaluation: &Evaluation) -> usize {
    evaluation
        .plastic
        .iter()
        .flat_map(|a| &a.flows)
        .filter(|f| f.is_some())
        .count()
}

/// Do so many elements flow that balance is lost to the plastic limit, if it is?
pub fn much_flows(model: &Model, flowing: &[u32]) -> bool {
    flowing.len() as f64 > LIMIT_FLOW_SHARE * model.scene.mesh.hexes.len() as f64
}

/// Elements that flow.
pub fn flowing_elements(model: &Model, evaluation: &Evaluation) -> Vec<u32> {
    let flowing = evaluation.plastic.iter().filter(|answer| answer.flows());
    (flowing.map(|answer| model.yielding[answer.index])).collect()
}
