//! A scene solved as one half, told to the outside as the whole.

use crate::model::half_turn::HalfTurn;
use crate::model::state::State;
use crate::solver::solve::checkpoint::restart::Restart;
use crate::solver::solve::increments::solution::{Solution, Unfinished};
use crate::solver::solve::observer::{Iteration, Observer};

type Stop = Box<dyn std::error::Error + Send + Sync>;

/// Hands the states of the half on as states of the whole.
pub struct Unfolding<'h, 'o> {
    pub half_turn: &'h HalfTurn,
    pub observer: &'o mut dyn Observer,
}

impl Observer for Unfolding<'_, '_> {
    fn iteration(&mut self, iteration: &Iteration) {
        self.observer.iteration(iteration);
    }

    fn increment(&mut self, state: &State) -> Result<(), Stop> {
        self.observer.increment(&self.half_turn.unfold(state))
    }

    fn checkpoint(&mut self, make: &dyn Fn() -> Restart) -> Result<(), Stop> {
        self.observer.checkpoint(make)
    }

    fn message(&mut self, text: &str) {
        self.observer.message(text);
    }

    fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }
}

impl Solution {
    /// That of the whole, where this is that of the half.
    pub(in crate::solver::solve) fn unfolded(mut self, half_turn: &HalfTurn) -> Self {
        let states = self.states.iter_mut().chain(&mut self.doubled);
        let elastic = self.elastic.iter_mut().chain(&mut self.elastic_doubled);
        for state in states.chain(elastic) {
            *state = half_turn.unfold(state);
        }
        if !self.last.displacement.is_empty() {
            self.last = half_turn.unfold(&self.last);
        }
        let stays = self.stays.as_mut();
        stays
            .into_iter()
            .for_each(|stays| *stays = half_turn.unfold_stays(stays));
        self.half_turn = true;
        self
    }
}

impl Unfinished {
    /// That of the whole, where this is that of the half.
    pub(in crate::solver::solve) fn unfolded(mut self, half_turn: &HalfTurn) -> Self {
        self.solution = (self.solution).map(|solution| Box::new(solution.unfolded(half_turn)));
        self
    }
}
