//! Which elastic elements flow, or soon will.
//!
//! The share of yield of an element is its largest Mises stress over its flow stress. From the shares at one load those at
//! a larger load are guessed: the largest stress grows with a power of the load. A layer of neighbours is added, since
//! beside a contact that widens the stress grows from nothing.

use crate::solver::solve::checkpoint::point::Point;
use crate::solver::solve::model::settled::Settled;
use crate::solver::solve::model::system::Model;
use crate::solver::solve::params::{
    EARLY_YIELD_SHARE, LEAST_FLOW_SHARE, STRESS_GROWTH_POWER, STRESS_TAKEN_OVER,
};
use crate::solver::solve::start::load_names::load_names;
use crate::solver::solve::working_set::shares_of_yield::shares_of_yield;

/// What is known of the flow to come.
#[derive(Debug, Clone, Copy)]
pub enum Ahead {
    /// Nothing: the next increment takes loads larger by this factor.
    To(f64),
    /// The elements that will flow were foreseen. Where one was not, others like it are not far.
    Known,
    /// Loads are taken off: nothing but what flows now has to be learned.
    Less,
}

/// Elements to keep from now on, and whether one of them yields already: then the solution is wrong without them.
///
/// `u` are the displacements of all nodes at the point `x`. If the largest share of yield will not reach one before the
/// next look, nothing is added. Else all elements are added that will yield until the largest load to come, and one
/// layer of their neighbours.
pub fn unexpected_flow(
    model: &Model,
    settled: &Settled,
    (x, u): (&Point, &[[f64; 3]]),
    ahead: Ahead,
) -> (Vec<u32>, bool) {
    let shares = shares_of_yield(model, settled, (u, (x.step, x.time)));
    let most = largest_share(&shares);
    let (next, share) = match ahead {
        Ahead::To(next) => {
            let to_come = load_to_come(model, x);
            (
                next.min(to_come),
                EARLY_YIELD_SHARE / to_come.powf(STRESS_GROWTH_POWER),
            )
        }
        Ahead::Known => (1.0, EARLY_YIELD_SHARE),
        Ahead::Less => (1.0, 1.0),
    };
    // Nothing will flow before the next look.
    if most * next.powf(STRESS_GROWTH_POWER) <= 1.0 {
        return (Vec::new(), false);
    }
    let elements = shares_above(&shares, share);
    (with_neighbours(model, &shares, &elements), most > 1.0)
}

/// Elements that will flow, from the `shares` of yield in the elastic solution at full load. Where the stress exceeds
/// yield, neighbours take over some of it and contact widens: the more it exceeds, the smaller are the elastic shares
/// from which elements flow in the end.
pub fn flow_to_come(shares: &[(u32, f64)]) -> Vec<u32> {
    let share = 1.0 - STRESS_TAKEN_OVER * (largest_share(shares) - 1.0);
    shares_above(shares, share.clamp(LEAST_FLOW_SHARE, 1.0))
}

/// The largest share of yield.
fn largest_share(shares: &[(u32, f64)]) -> f64 {
    shares.iter().map(|(_, share)| *share).fold(0.0, f64::max)
}

/// Elements whose share of yield is larger than `share`.
fn shares_above(shares: &[(u32, f64)], share: f64) -> Vec<u32> {
    let elements = shares.iter().filter(|(_, s)| *s > share);
    elements.map(|(element, _)| *element).collect()
}

/// `elements` and all that have a node in common with them, of those that `shares` are known of.
fn with_neighbours(model: &Model, shares: &[(u32, f64)], elements: &[u32]) -> Vec<u32> {
    let hexes = &model.scene.mesh.hexes;
    let mut beside = vec![false; model.scene.mesh.points.len()];
    for node in elements.iter().flat_map(|e| hexes[*e as usize]) {
        beside[node as usize] = true;
    }
    let touches = |e: &u32| hexes[*e as usize].iter().any(|n| beside[*n as usize]);
    let all = shares.iter().map(|(element, _)| *element);
    all.filter(touches).collect()
}

/// How many times larger than now a load still gets.
fn load_to_come(model: &Model, x: &Point) -> f64 {
    let scene = model.scene;
    let ratios = load_names(scene).map(|name| {
        let now = model.scene.factor(name, x.step, x.time).abs();
        let later = scene.steps[x.step..].iter();
        let most = later.map(|s| s.factor_of(name).abs()).fold(0.0, f64::max);
        if now > 0.0 { most / now } else { 1.0 }
    });
    ratios.fold(1.0, f64::max)
}
