//! How far an answer depends on the size of the increments that led to it.
//!
//! Plastic flow is integrated along the path, increment by increment. Beside the history that the
//! solution follows run two that take two increments in one, under the same displacements, one of
//! them begun an increment later: at every increment one of the two has just taken such a double
//! step. Backward Euler being of first order, it is twice as far off as the history itself, so that
//! the difference between them is the error of the latter.

use super::evaluate::{PlasticElement, watch};
use super::model::Model;
use super::restart::{Plastic, histories_of, plastic_of};
use crate::material::j2::PlasticPoint;
use crate::material::mises;
use crate::results::PathError;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// The histories of double increments, by element of [`Model::yielding`].
#[derive(Clone, Default)]
pub struct Path {
    double: [Vec<PlasticElement>; 2],
    increments: usize,
}

/// The same by element of the mesh.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct KeptPath {
    double: [Plastic; 2],
    increments: usize,
}

/// What an element contributes.
struct Difference {
    body: usize,
    /// Plastic strain at the point that has most.
    peak: f64,
    /// How far that strain and the stress are off there; the latter as a Mises stress.
    strain: f64,
    stress: f64,
    /// Work of the difference of the stresses.
    work: f64,
}

impl Path {
    /// For a model with this many watched elements.
    pub fn new(elements: usize) -> Self {
        Self {
            double: [vec![None; elements], vec![None; elements]],
            increments: 0,
        }
    }

    /// Carries the histories from the elements that were watched to those that will be.
    pub fn watch(&mut self, old: &[u32], new: &[u32]) {
        for double in &mut self.double {
            *double = watch(std::mem::take(double), old, new);
        }
    }

    /// Takes a double step to the displacements `u` of an accepted increment, whose own history is
    /// `single`; `None` where there is no increment before it or nothing has yielded.
    pub fn advance(
        &mut self,
        model: &Model,
        single: &[PlasticElement],
        u: &[[f64; 3]],
    ) -> Option<PathError> {
        let which = self.increments % 2;
        self.increments += 1;
        if single.iter().all(Option::is_none) {
            return None;
        }
        let double = &mut self.double[which];
        let differences: Vec<Difference> = (double.par_iter_mut().zip(single))
            .zip(&model.yielding)
            .filter_map(|((double, single), element)| step(model, *element, double, single, u))
            .collect();
        if self.increments == 1 {
            return None;
        }
        let bodies = model.scene.mesh.bodies.len();
        let (mut stress, mut strain) = (vec![None; bodies], vec![None; bodies]);
        let mut peak = vec![0.0; bodies];
        for d in &differences {
            if d.peak > peak[d.body] {
                peak[d.body] = d.peak;
                // What has flowed in one increment only says nothing.
                let known = d.stress > 0.0;
                stress[d.body] = known.then_some(d.stress);
                strain[d.body] = known.then_some(d.strain);
            }
        }
        Some(PathError {
            stress,
            plastic_strain: strain,
            work: differences.iter().map(|d| d.work).sum::<f64>().abs(),
        })
    }

    pub fn keep(&self, model: &Model) -> KeptPath {
        KeptPath {
            double: self.double.each_ref().map(|d| plastic_of(model, d)),
            increments: self.increments,
        }
    }
}

impl KeptPath {
    pub fn place(&self, model: &Model) -> Path {
        Path {
            double: self.double.each_ref().map(|d| histories_of(model, d)),
            increments: self.increments,
        }
    }

    /// All elements that are in it.
    pub fn elements(&self) -> impl Iterator<Item = u32> {
        self.double.iter().flatten().map(|(element, _)| *element)
    }
}

/// Steps the `double` history of an element and compares it with the `single` one.
fn step(
    model: &Model,
    element: u32,
    double: &mut PlasticElement,
    single: &PlasticElement,
    u: &[[f64; 3]],
) -> Option<Difference> {
    if double.is_none() && single.is_none() {
        return None;
    }
    let mesh = &model.scene.mesh;
    let body = mesh.body_of(element as usize);
    let (steel, elastic) = (&model.scene.materials[body], &model.elastic[body]);
    let shape = model.element(element);
    let local = mesh.hexes[element as usize].map(|n| u[n as usize]);
    let virgin = [PlasticPoint::default(); 8];
    let start = double.as_deref().unwrap_or(&virgin);
    let coarse = shape.answer(steel, elastic, &local, start)?.points;
    let fine = single.as_deref().unwrap_or(&virgin);
    let at = (0..8).max_by(|a, b| fine[*a].peeq.total_cmp(&fine[*b].peeq))?;
    let off = std::array::from_fn(|i| coarse[at].strain[i] - fine[at].strain[i]);
    let forces = shape.relief(elastic, &coarse);
    let others = shape.relief(elastic, fine);
    let pairs = forces.as_flattened().iter().zip(others.as_flattened());
    let work = pairs
        .zip(local.as_flattened())
        .map(|((c, f), u)| (c - f) * u);
    let work = work.sum();
    *double = Some(Box::new(coarse));
    Some(Difference {
        body,
        peak: fine[at].peeq,
        strain: (coarse[at].peeq - fine[at].peeq).abs(),
        stress: mises(&elastic.stress(&off)),
        work,
    })
}
