//! How well an answer satisfies its own equations.

use super::inputs::AnswerInputs;
use super::named::Named;
use crate::answer::results::balance::balances;
use crate::answer::results::interface::Interface;
use crate::answer::results::{levels, load};
use crate::ground::geometry::norm;
use crate::model::scene::Scene;
use crate::model::state::State;
use serde::Serialize;

/// Force that does not balance, or that stabilisation carries, and overlap of bodies beside the descent: what is said from this share
/// on, and fails a run.
pub const NOTABLE_SHARE: f64 = 1e-3;

/// Relative figures that say how well the answer satisfies its own equations.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Checks {
    /// Largest difference between the load and the force that passes between two levels of the stack, relative to the
    /// load: of an interface, or of all that lie side by side. Levels below a load that others do not share are left out.
    pub force_balance: Option<f64>,
    /// Largest penetration that the facets do not explain, relative to the descent; where loads oppose each other, to the largest
    /// displacement.
    pub max_penetration_relative: Option<f64>,
    /// Largest tangential traction beyond μ p, relative to μ times the largest pressure.
    pub coulomb_violation: Option<f64>,
    /// Work of the loads that is neither stored nor spent, relative to all work done.
    pub energy_imbalance: Option<f64>,
    /// Share of the load that stabilisation carries.
    pub stabilisation_share: Option<f64>,
}

/// The checks of the answer.
pub fn checks(solved: &AnswerInputs, measured: &[Interface], load: f64) -> Checks {
    let (scene, state) = (solved.scene, solved.state);
    let largest_motion = || {
        state
            .displacement
            .iter()
            .map(|u| norm(*u))
            .fold(0.0, f64::max)
    };
    let opposed = load::oppose(scene, state);
    let descent = match opposed {
        true => Some(largest_motion()),
        false => load::descent(scene, state),
    };
    let largest = |of: &dyn Fn(&Interface) -> f64| measured.iter().map(of).fold(0.0, f64::max);
    let passing = levels::passing(scene, state, measured);
    let off = passing.iter().map(|force| (force - load).abs());
    let off = off.fold(0.0, f64::max);
    let relative = |value: f64, to: f64| (to != 0.0).then(|| value / to.abs());
    let some = |value: Option<f64>| value.filter(|_| !measured.is_empty());
    let penetration = || relative(largest(&|i| i.unexplained_penetration), descent?);
    Checks {
        force_balance: some(relative(off, load)).filter(|_| !opposed && !passing.is_empty()),
        max_penetration_relative: some(penetration()),
        coulomb_violation: some(Some(largest(&|i| i.coulomb_violation))),
        energy_imbalance: solved.state.energy.and_then(|energy| energy.imbalance()),
        stabilisation_share: solved.stabilisation_share,
    }
}

/// Sums of the contact forces on a body, and of their moments about its middle; of the whole.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, schemars::JsonSchema)]
pub struct BalanceFigures {
    /// Sum of the contact forces on the body.
    pub force: [f64; 3],
    /// Sum of their moments about the middle of the body.
    pub moment: [f64; 3],
}

/// The balance of every body that nothing but contact holds.
pub fn balance(scene: &Scene, state: &State) -> Named<BalanceFigures> {
    let bodies = balances(scene, state).into_iter();
    let summary = bodies.map(|b| {
        let (force, moment) = (b.force, b.moment);
        (b.body, BalanceFigures { force, moment })
    });
    Named(summary.collect())
}
