//! What is carried from increment to increment: plastic strains and slip.

use crate::solver::contact::law::Status;
use crate::solver::fem::loads::at_nodes;
use crate::solver::solve::checkpoint::plastic::{Plastic, PlasticElement, PlasticStrains};
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::Evaluation;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;
use rayon::prelude::*;

/// Of one solution, for one model.
#[derive(Clone)]
pub struct History {
    /// Plastic state by element of [`Model::yielding`].
    pub plastic: Vec<PlasticElement>,
    /// That of all others.
    pub settled: Settled,
    /// Relative tangential displacement of each contact row at the last increment.
    pub slip_origin: Vec<[f64; 2]>,
    /// Accumulated slip length of each row.
    pub slip: Vec<f64>,
}

impl History {
    /// Before anything has happened.
    pub fn virgin(model: &Model) -> Self {
        let rows = model.rows.len();
        Self::new(
            model,
            Plastic::new(),
            (vec![[0.0; 2]; rows], vec![0.0; rows]),
        )
    }

    /// Of the elements that have flowed, and of the origin and length of slip of each contact row.
    pub fn new(
        model: &Model,
        plastic: Plastic,
        (slip_origin, slip): (Vec<[f64; 2]>, Vec<f64>),
    ) -> Self {
        let mut history = Self {
            plastic: Vec::new(),
            settled: Settled::default(),
            slip_origin,
            slip,
        };
        history.place_plastic(model, plastic);
        history
    }

    /// Has nothing flowed yet?
    pub fn is_virgin(&self) -> bool {
        self.settled.elements.is_empty() && self.plastic.iter().all(Option::is_none)
    }

    /// Goes on to an increment that is in balance.
    pub fn advance(&mut self, point: &mut Point, evaluation: &Evaluation) {
        for answer in &evaluation.plastic {
            self.plastic[answer.index] = Some(answer.points.clone());
        }
        self.slide(point, evaluation);
    }

    /// The same of contact alone.
    pub fn slide(&mut self, point: &mut Point, evaluation: &Evaluation) {
        let rows = evaluation.contact.iter().zip(&evaluation.relative);
        for (index, (answer, d)) in rows.enumerate() {
            if answer.status == Status::Slip {
                self.slip[index] += d[1].hypot(d[2]);
            }
            for i in 0..2 {
                self.slip_origin[index][i] += d[1 + i];
            }
        }
        start_from(point, evaluation);
    }

    /// Gives elements of [`Model::yielding`] `times` that much plastic strain.
    pub fn gain(&mut self, model: &Model, strains: &PlasticStrains, times: f64) {
        for (element, strains) in strains {
            let Ok(at) = model.yielding.binary_search(element) else {
                continue;
            };
            let points = self.plastic[at].get_or_insert_default();
            for (point, strain) in points.iter_mut().zip(strains) {
                let both = point.strain.iter_mut().zip(strain);
                both.for_each(|(sum, e)| *sum += times * e);
            }
        }
    }

    /// All elements that have flowed.
    pub fn all_plastic(&self, model: &Model) -> Plastic {
        let watched = model.yielding.iter().zip(&self.plastic);
        let watched = watched.filter_map(|(e, points)| Some((*e, **points.as_ref()?)));
        let mut all: Plastic = watched.chain(self.settled.elements.clone()).collect();
        all.sort_unstable_by_key(|(e, _)| *e);
        all
    }

    /// Takes over the elements that have flowed, for the elements that `model` watches.
    pub fn place_plastic(&mut self, model: &Model, all: Plastic) {
        self.plastic = vec![None; model.yielding.len()];
        let mut settled = Plastic::new();
        for (element, points) in all {
            match model.yielding.binary_search(&element) {
                Ok(at) => self.plastic[at] = Some(Box::new(points)),
                Err(_) => settled.push((element, points)),
            }
        }
        self.settled = Settled::new(model, settled);
    }
}

/// Makes a point in balance one that the next increment starts from, or its first guess.
pub fn start_from(point: &mut Point, evaluation: &Evaluation) {
    for (node, answer) in point.nodes.iter_mut().zip(&evaluation.contact) {
        node.multiplier = answer.traction;
        node.origin = [0.0; 2];
    }
}

impl Settled {
    pub fn new(model: &Model, elements: Plastic) -> Self {
        if elements.is_empty() {
            return Self::default();
        }
        let mesh = &model.scene.mesh;
        let of_element = |(element, points): &(u32, _)| {
            let elastic = &model.elastic[mesh.body_of(*element as usize)];
            let relief = model.element(*element).relief(elastic, points);
            (mesh.hexes[*element as usize], relief)
        };
        let forces: Vec<_> = elements.par_iter().map(of_element).collect();
        let mut forces = model.all.gather(&at_nodes(mesh.points.len(), forces));
        model.bodies.reduce(&mut forces);
        Self { elements, forces }
    }
}
