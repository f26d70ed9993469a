//! How the iterations of an increment come on.

use crate::solver::solve::newton::friction_bounds::Bounds;
use crate::solver::solve::params::{
    HOPELESS_RESIDUAL, LOST_DECREASE, LOST_RESIDUAL, STEADY_DECREASE, WAVE_ITERATIONS,
};

/// How the iterations of an increment have come on.
#[derive(Default)]
pub struct Progress {
    /// Residual after λ of cautious nodes was taken.
    pub begun: Option<f64>,
    /// Residual after each correction.
    pub residuals: Vec<f64>,
    /// Energy of each correction.
    pub energies: Vec<f64>,
    pub bounds: Bounds,
    /// For how many iterations has no node changed between open, stick and slip?
    pub settled: usize,
}

impl Progress {
    /// Is there no balance in sight?
    ///
    /// Where shears become multipliers the residual may rise before it falls; such a wave takes [`WAVE_ITERATIONS`].
    /// Beyond the plastic limit iterations wander far from balance. An increment that has a balance comes near it after
    /// a wave or two, and never misses it by a third of the load for half a wave.
    pub fn is_lost(&self) -> bool {
        const HALF: usize = WAVE_ITERATIONS / 2;
        let least = |residuals: &[f64]| residuals.iter().copied().fold(f64::INFINITY, f64::min);
        if (self.residuals.last_chunk::<HALF>()).is_some_and(|all| least(all) > HOPELESS_RESIDUAL) {
            return true;
        }
        let lately = self.residuals.last_chunk::<{ 2 * WAVE_ITERATIONS }>();
        lately.is_some_and(|both| {
            let [before, now] = [&both[..WAVE_ITERATIONS], &both[WAVE_ITERATIONS..]].map(least);
            now > LOST_RESIDUAL && now > LOST_DECREASE * before
        })
    }

    /// Do corrections become smaller so steadily that it would be a waste to stop?
    pub fn goes_on(&self) -> bool {
        let most = |energies: &[f64]| energies.iter().copied().fold(0.0, f64::max);
        let lately = self.energies.last_chunk::<{ 2 * WAVE_ITERATIONS }>();
        lately.is_some_and(|both| {
            most(&both[WAVE_ITERATIONS..]) < STEADY_DECREASE * most(&both[..WAVE_ITERATIONS])
        })
    }
}
