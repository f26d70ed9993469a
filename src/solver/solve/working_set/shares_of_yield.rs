//! How far each elastic element is from yield.

use crate::model::material::j2::PlasticPoint;
use crate::model::material::mises;
use crate::solver::solve::checkpoint::plastic::points;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::start::can_yield::can_yield;
use rayon::prelude::*;

/// The largest Mises stress over the flow stress of every element that could yield and is not watched,
/// as long as it does not flow.
pub fn shares_of_yield(
    model: &Model,
    settled: &Settled,
    (u, moment): (&[[f64; 3]], (usize, f64)),
) -> Vec<(u32, f64)> {
    let scene = model.scene;
    (0..scene.mesh.hexes.len() as u32)
        .into_par_iter()
        .filter(|e| can_yield(scene, *e) && model.yielding.binary_search(e).is_err())
        .map(|e| {
            let body = scene.mesh.body_of(e as usize);
            let local = scene.mesh.hexes[e as usize].map(|n| u[n as usize]);
            let points = points(&settled.elements, e);
            let stress = model.element(e).stress(
                &model.elastic[body],
                &local,
                &model.free_strains(e, points, moment),
            );
            let steel = &scene.materials[body];
            let share = |(stress, point): (&_, &PlasticPoint)| {
                mises(stress) / steel.flow_stress(point.peeq)
            };
            (e, stress.iter().zip(&points).map(share).fold(0.0, f64::max))
        })
        .collect()
}
