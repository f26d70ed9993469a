//! Where the iterations of a solution went.

use crate::solver::solve::params::UNREMARKABLE_ITERATIONS;
use serde::{Deserialize, Serialize};

/// Iterations beside those that led straight to an accepted increment, and where a step began.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// All that were taken before the step under way.
    pub before_step: usize,
    /// In increments that were given up.
    pub given_up: usize,
    /// In increments that were solved once more, since contact or flow was not foreseen, or flow turned.
    pub unforeseen: usize,
    /// With springs that hold bodies back.
    pub held_back: usize,
    /// Of the second solution, in increments twice as large.
    pub second: usize,
}

impl Effort {
    /// Why a solution took so many `iterations`, in words; `None` where these are not many.
    pub fn reason(&self, iterations: usize, cut_backs: usize) -> Option<String> {
        let given_up = format!("in increments that were given up ({cut_backs} cut-backs)");
        let parts = [
            (self.given_up, given_up.as_str()),
            (
                self.unforeseen,
                "in increments solved once more, since contact or flow was not foreseen, or flow turned",
            ),
            (
                self.held_back,
                "with springs that held bodies back for a first guess",
            ),
            (
                self.second,
                "for the second solution, in increments twice as large",
            ),
        ];
        let rest = iterations.saturating_sub(parts.iter().map(|(count, _)| count).sum());
        let rest = (rest, "in the accepted increments");
        let spent = parts.iter().copied().chain([rest]);
        let words: Vec<_> = spent
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        (iterations > UNREMARKABLE_ITERATIONS)
            .then(|| format!("{iterations} iterations: {}", words.join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_iterations_are_accounted_for() {
        let effort = Effort {
            given_up: 120,
            second: 80,
            ..Effort::default()
        };
        assert_eq!(effort.reason(300, 3), None);
        assert_eq!(
            effort.reason(301, 3).as_deref(),
            Some(
                "301 iterations: 120 in increments that were given up (3 cut-backs), 80 for the second \
                 solution, in increments twice as large, 101 in the accepted increments"
            )
        );
    }
}
