//! What plastic flow has spent of the energy of a solution, below strips and elsewhere.

use super::contacts::Contacts;
use super::energy;
use super::strip_below::StripBelow;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::{Energy, State};

/// What plastic flow has to do with the energy of a solution, as shares of that.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct FlowShares {
    pub below_strips: f64,
    /// That no strip is above.
    pub away: f64,
    /// Of stress beyond flow on the strain that steel hardens by meanwhile, see [`FreeFlow`](energy::FreeFlow), in bodies that no strip
    /// presses.
    pub beyond: f64,
}

impl FlowShares {
    pub fn of(scene: &Scene, state: &State, recovered: &Recovered, contacts: Contacts) -> Self {
        let all = state.energy.map_or(0.0, plastic_share);
        if all == 0.0 {
            return Self::default();
        }
        let strips = StripBelow::all(scene, contacts.lines);
        let free = energy::free_flow(scene, state, recovered, &strips);
        let away = all * free.share;
        let bodies = free.work_beyond.into_iter().enumerate();
        let beyond = bodies.filter(|(body, _)| !contacts.is_below_strip(scene, *body));
        let beyond: f64 = beyond.map(|(_, work)| work).sum();
        Self {
            below_strips: all - away,
            away,
            beyond: beyond / energy::of_solution(scene, state, recovered) * (1.0 - all),
        }
    }
}

/// Share of the energy of a solution that plastic flow has spent.
fn plastic_share(energy: Energy) -> f64 {
    let whole = energy.elastic + energy.plastic;
    if whole > 0.0 {
        energy.plastic / whole
    } else {
        0.0
    }
}
