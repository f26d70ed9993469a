//! What a run does, and its end when it has taken too long.

use crate::model::state::State;
use crate::solver::solve::{Iteration, Observer};
use std::time::{Duration, Instant};

/// Longer than this no case may take.
const LONGEST_RUN: Duration = Duration::from_secs(120);

/// Counts iterations.
#[derive(Debug)]
pub struct RandomWatch {
    start: Instant,
    longest: Duration,
    pub iterations: usize,
    /// Of the increment that is under way, cut-backs included.
    now: usize,
    /// The most that an accepted increment took, cut-backs included.
    pub most: usize,
    /// When accepted increments ended.
    pub times: Vec<f64>,
}

impl RandomWatch {
    pub fn start() -> Self {
        Self::of(LONGEST_RUN)
    }

    /// One that may take so long.
    pub fn of(longest: Duration) -> Self {
        Self {
            start: Instant::now(),
            longest,
            iterations: 0,
            now: 0,
            most: 0,
            times: Vec::new(),
        }
    }

    pub fn seconds(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }
}

impl Observer for RandomWatch {
    fn iteration(&mut self, _: &Iteration) {
        self.iterations += 1;
        self.now += 1;
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.most = self.most.max(self.now);
        self.now = 0;
        self.times.push(state.time);
        Ok(())
    }

    fn cancelled(&self) -> bool {
        self.start.elapsed() > self.longest
    }
}
