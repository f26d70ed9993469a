//! What plastic flow has spent of the energy of a solution, below strips and elsewhere.

use super::energy;
use super::strip_below::StripBelow;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::{Energy, State};

/// Shares of the energy of a solution that plastic flow has spent.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct FlowShares {
    pub below_strips: f64,
    /// That no strip is above.
    pub away: f64,
}

impl FlowShares {
    pub fn of(
        scene: &Scene,
        state: &State,
        recovered: &Recovered,
        lines: &[Option<HeaviestLine>],
    ) -> Self {
        let all = state.energy.map_or(0.0, plastic_share);
        if all == 0.0 {
            return Self::default();
        }
        let strips = StripBelow::all(scene, lines);
        let away = all * energy::flow_away(scene, state, recovered, &strips);
        Self {
            below_strips: all - away,
            away,
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
