//! What an increment is solved for.

use crate::solver::solve::linear_system::proximal_springs::ProximalSprings;
use crate::solver::solve::working_set::flow::Ahead;

/// What an increment is solved for.
#[derive(Clone, Copy)]
pub enum Goal<'s> {
    /// Balance, if no element flows that is not watched, though all it takes is to watch it: that is looked for as soon as
    /// balance is near. It says how far flow is to be foreseen then.
    Foreseen(Ahead),
    /// Balance, whatever flows.
    Balance,
    /// What the increments are worth: balance to [`ROUGH_BALANCE`](crate::solver::solve::params::ROUGH_BALANCE).
    Estimate,
    /// Rough balance with springs: a turn of the proximal point method.
    Held(&'s ProximalSprings),
}

impl<'s> Goal<'s> {
    pub fn springs(self) -> Option<&'s ProximalSprings> {
        match self {
            Self::Held(springs) => Some(springs),
            _ => None,
        }
    }
}
