//! The elements that flow in an increment, and by how far the direction of their flow turns in it.

use crate::ground::geometry::Vec3;
use crate::model::material::j2::PlasticPoint;
use crate::model::material::mises;
use crate::model::mesh::hexahedron::{gauss_volumes, volume};
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::solver::solve::checkpoint::plastic::PlasticStrains;
use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::equilibrium::evaluation::{Evaluation, PlasticAnswer};
use crate::solver::solve::increments::run::Run;
use rayon::prelude::*;
use std::array::from_fn;

/// An element that flows in an increment.
pub struct Flowing {
    element: u32,
    volume: f64,
    /// Stresses at its integration points before the increment,
    before: [[f64; 6]; 8],
    /// at its end if they did not flow in it, as strain is given,
    pub elastic: [[f64; 6]; 8],
    /// and as they are, as stress is given.
    pub after: [[f64; 6]; 8],
    /// What they flow at.
    flow_stress: [f64; 8],
    /// Plastic strain that they gain,
    gains: [f64; 8],
    /// and by how far the direction of stress turns from where they begin to flow to the end.
    turns: [[f64; 6]; 8],
}

impl Flowing {
    /// By how much the stress on its straight way to one of these ends exceeds yield at a share of the increment, times the volume.
    pub fn excess(&self, end: &[[f64; 6]; 8], share: f64) -> f64 {
        let shares =
            (0..8).map(|k| mises(&between(&self.before[k], &end[k], share)) / self.flow_stress[k]);
        self.volume * (shares.fold(0.0, f64::max) - 1.0).max(0.0)
    }

    /// Plastic strain in a direction that the increment does not have from where it begins to flow, but at its end, times the volume: half of what it
    /// gains, by how far the direction of stress turns meanwhile.
    pub fn turned(&self) -> f64 {
        let of_point = |k: usize| {
            let turn = self.turns[k];
            let apart: f64 = (0..6)
                .map(|i| turn[i].powi(2) * if i < 3 { 1.0 } else { 2.0 })
                .sum();
            0.5 * self.gains[k] * apart.sqrt()
        };
        self.volume / 8.0 * (0..8).map(of_point).sum::<f64>()
    }

    /// The plastic strain at each integration point, with engineering shears, that it lacks for that: flow whose direction turns evenly has, in the mean, one midway between
    /// the first and the last.
    fn lacks(&self) -> [[f64; 6]; 8] {
        from_fn(|k| {
            from_fn(|i| {
                let engineering = if i < 3 { 1.0 } else { 2.0 };
                -0.5 * 1.5f64.sqrt() * self.gains[k] * engineering * self.turns[k][i]
            })
        })
    }
}

/// From the direction of stress where it leaves the yield surface, on the straight way from `before` to `elastic`, to that of `after`.
fn turn(before: &[f64; 6], [elastic, after]: [&[f64; 6]; 2], flow_stress: f64) -> [f64; 6] {
    let begins = onset(before, elastic, flow_stress);
    let from = direction(&between(before, elastic, begins));
    let to = direction(after);
    from_fn(|i| to[i] - from[i])
}

/// Deviator of a stress over its size.
fn direction(stress: &[f64; 6]) -> [f64; 6] {
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    let deviator: [f64; 6] = from_fn(|i| stress[i] - if i < 3 { mean } else { 0.0 });
    let size = mises(stress) * (2.0f64 / 3.0).sqrt();
    deviator.map(|s| if size > 0.0 { s / size } else { 0.0 })
}

/// A stress on the straight way from one to another.
fn between(before: &[f64; 6], after: &[f64; 6], share: f64) -> [f64; 6] {
    from_fn(|k| before[k] + share * (after[k] - before[k]))
}

/// Share of the way between two stresses at which it leaves the yield surface.
fn onset(before: &[f64; 6], after: &[f64; 6], flow_stress: f64) -> f64 {
    const HALVINGS: i32 = 30;
    (1..=HALVINGS).fold(0.0, |begins, k| {
        let next = begins + 0.5f64.powi(k);
        let inside = mises(&between(before, after, next)) < flow_stress;
        if inside { next } else { begins }
    })
}

impl Run<'_, '_> {
    /// The elements that flow in the increment to `trial`, with the displacements `u`.
    pub(super) fn flowing(
        &self,
        (trial, u): (&Point, &[Vec3]),
        evaluation: &Evaluation,
    ) -> Vec<Flowing> {
        let (model, history) = (&self.model, &self.history);
        let scene = model.scene;
        let start = model.displacement(&self.point, &history.settled);
        let moments = [self.stands(trial.step), trial.time].map(|time| (trial.step, time));
        let flows = evaluation
            .plastic
            .par_iter()
            .filter(|answer| answer.flows());
        let of_element = |answer: &PlasticAnswer| {
            let element = model.yielding[answer.index];
            let body = scene.mesh.body_of(element as usize);
            let steel = &scene.materials[body];
            let points = history.plastic[answer.index].as_deref();
            let points: [PlasticPoint; 8] = points.copied().unwrap_or_default();
            let stress = |u: &[Vec3], points, moment| {
                let local = scene.mesh.hexes[element as usize].map(|node| u[node as usize]);
                let free = model.free_strains(element, points, moment);
                model
                    .element(element)
                    .stress(&model.elastic[body], &local, &free)
            };
            let before = stress(&start, points, moments[0]);
            let elastic = stress(u, points, moments[1]);
            let after = stress(u, *answer.points, moments[1]);
            let flow_stress = points.map(|point| steel.flow_stress(point.peeq));
            Flowing {
                element,
                volume: volume(&scene.mesh.corners(element as usize)),
                gains: from_fn(|k| answer.points[k].peeq - points[k].peeq),
                turns: from_fn(|k| turn(&before[k], [&elastic[k], &after[k]], flow_stress[k])),
                before,
                elastic,
                after,
                flow_stress,
            }
        };
        flows.map(of_element).collect()
    }
}

/// The plastic strain that each lacks at its integration points.
pub fn lacking(flowing: &[Flowing]) -> PlasticStrains {
    let of_element = |element: &Flowing| (element.element, element.lacks());
    flowing.iter().map(of_element).collect()
}

/// What stresses do, from one state to the next, on plastic strain that elements are given.
pub fn work_on(strains: &PlasticStrains, scene: &Scene, states: [&State; 2]) -> f64 {
    let of_element = |(element, strains): &(u32, [[f64; 6]; 8])| {
        let element = *element as usize;
        let volumes = gauss_volumes(&scene.mesh.corners(element));
        let of_state = |state: &State| -> f64 {
            let stresses = state.stress.get(element).into_iter().flatten();
            let works = stresses.zip(strains).zip(volumes);
            works
                .map(|((stress, strain), volume)| {
                    volume * stress.iter().zip(strain).map(|(s, e)| s * e).sum::<f64>()
                })
                .sum()
        };
        0.5 * states.map(of_state).iter().sum::<f64>()
    };
    strains.iter().map(of_element).sum()
}
