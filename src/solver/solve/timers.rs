//! Seconds spent in each phase of a solution. Reported, never decided upon.

use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Phases of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Equations, contact rows, pattern, order, elastic stiffness.
    Prepare,
    /// Residuals: yield checks, contact laws.
    Evaluate,
    /// Tangent matrices.
    Assemble,
    /// Factorising.
    Factorise,
    /// Krylov directions with the factor.
    LinearSolve,
    /// Fields at accepted increments.
    Recover,
}

impl Phase {
    /// All, in the order in which they are told.
    pub const ALL: [Self; 6] = [
        Self::Prepare,
        Self::Evaluate,
        Self::Assemble,
        Self::Factorise,
        Self::LinearSolve,
        Self::Recover,
    ];

    /// In words, for tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Prepare => "prepare",
            Self::Evaluate => "evaluate",
            Self::Assemble => "assemble",
            Self::Factorise => "factorise",
            Self::LinearSolve => "linear solves",
            Self::Recover => "recover",
        }
    }
}

/// Seconds by phase.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Timers([f64; 6]);

impl Timers {
    /// Runs `work` and adds its seconds to `phase`.
    pub fn time<T>(&mut self, phase: Phase, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let out = work();
        self.0[phase as usize] += start.elapsed().as_secs_f64();
        out
    }

    /// Adds the seconds of `other`.
    pub fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(t, o)| *t += o);
    }

    /// Seconds of `phase`.
    pub fn seconds(&self, phase: Phase) -> f64 {
        self.0[phase as usize]
    }
}
