//! What a solved scene leaves behind.

use crate::model::state::State;
use crate::solver::solve::checkpoint::counters::Counters;
use crate::solver::solve::error::SolveError;
use crate::solver::solve::start::close_gaps::Closing;

/// What a solved scene leaves behind.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The state at the end of each finished step.
    pub states: Vec<State>,
    /// The last accepted state.
    pub last: State,
    /// The end of a step if no steel had yielded, where that was found on the way: displacements,
    /// stresses and contact, no accumulated slip.
    pub elastic: Option<State>,
    /// The same end in increments twice as large, where bodies rub.
    pub elastic_doubled: Option<State>,
    /// The ends of steps in increments twice as large, where something has rubbed or yielded.
    pub doubled: Vec<State>,
    /// Displacement of every node that stays once all loads are off, where they were taken off to the end
    /// ([`spring_back`](crate::solver::solve::spring_back())).
    pub stays: Option<Vec<[f64; 3]>>,
    /// How often the expensive parts ran, and the sizes of the model.
    pub counters: Counters,
    /// Bodies that were moved into touch before the load.
    pub closings: Vec<Closing>,
    /// Contact pairs whose surfaces overlap before the load, and by how much where they do most.
    pub overlapping: Vec<(String, f64)>,
    /// Were all steps finished, or all but the taking off of the load?
    pub complete: bool,
    /// Was it stopped on demand before that?
    pub interrupted: bool,
    /// Was one half of it solved, as it is its own image under a half turn?
    pub half_turn: bool,
    /// Why the load was not taken off to the end, in words, where all steps before were finished.
    pub stuck: Option<String>,
    /// Why it took many iterations, in words, where it did.
    pub laborious: Option<String>,
}

/// What came of a solution that did not get to its end.
#[derive(Debug)]
pub struct Unfinished {
    /// Why it did not.
    pub error: SolveError,
    /// Up to the last accepted increment; `None` where there is none.
    pub solution: Option<Box<Solution>>,
}

impl<E: Into<SolveError>> From<E> for Unfinished {
    fn from(error: E) -> Self {
        Self {
            error: error.into(),
            solution: None,
        }
    }
}
