//! Where increments end in plastic flow: at equal shares of the flow that is to come.
//!
//! Flow may begin in a corner early and in the bulk late. Increments that are equal in load would see the
//! second in one piece, and say nothing about their own error.

use crate::solver::solve::params::{FLOW_PARTS, NEGLIGIBLE_FLOW, STEP_END_LOG, STRESS_POWERS};

/// How the stress of an element grows as long as it is elastic.
#[derive(Debug, Clone, Copy)]
pub struct Growth {
    pub volume: f64,
    /// Its Mises stress over the yield stress at the end of the step,
    pub share: f64,
    /// and by which power of the load it gets there.
    pub power: f64,
}

impl Growth {
    /// From the share of yield `now`, at a time in the step, to that at its end.
    ///
    /// At the end itself nothing tells the power: stress is taken to grow evenly, not as rounding has it.
    pub fn new(volume: f64, (time, now): (f64, f64), share: f64) -> Self {
        let way = (1.0 / time).ln();
        let power = if way > STEP_END_LOG {
            (share / now).ln() / way
        } else {
            1.0
        };
        let [least, most] = STRESS_POWERS;
        Self {
            volume,
            share,
            power: if power.is_nan() {
                1.0
            } else {
                power.clamp(least, most)
            },
        }
    }

    /// By how much the stress exceeds yield, times the volume.
    fn excess(&self, time: f64) -> f64 {
        self.volume * (self.share * time.powf(self.power) - 1.0).max(0.0)
    }
}

/// Ends of an even number of increments, none of them larger than `largest` after flow has begun; none at
/// all where nothing flows.
pub fn flow_ends(growth: &[Growth], largest: f64) -> Vec<f64> {
    let flowing: Vec<_> = growth.iter().filter(|g| g.share > 1.0).collect();
    equal_shares(|time| flowing.iter().map(|g| g.excess(time)).sum(), largest)
}

/// The same by what exceeds yield at a time from 0 to 1, where it has begun never less than before.
pub fn equal_shares(excess: impl Fn(f64) -> f64, largest: f64) -> Vec<f64> {
    let all = excess(1.0);
    let when = |share: f64| {
        let (mut before, mut after) = (0.0, 1.0);
        for _ in 0..30 {
            let middle = 0.5 * (before + after);
            if excess(middle) < share * all {
                before = middle
            } else {
                after = middle
            }
        }
        after
    };
    if all <= 0.0 {
        return Vec::new();
    }
    let plan = |parts: usize| -> Vec<f64> {
        let inner = (1..parts).map(|k| when(k as f64 / parts as f64));
        inner.chain([1.0]).collect()
    };
    let begins = when(NEGLIGIBLE_FLOW);
    let longest = |ends: &[f64]| {
        let starts = [begins].into_iter().chain(ends.iter().copied());
        let sizes = starts.zip(ends).map(|(start, end)| end - start);
        sizes.fold(0.0, f64::max)
    };
    let plans = (2..=FLOW_PARTS).step_by(2).map(plan);
    let mut fitting = plans.filter(|ends| longest(ends) <= largest);
    fitting.next().unwrap_or_else(|| plan(FLOW_PARTS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_of_equal_flow() {
        // Alike everywhere and from 0.5 on, in proportion to the load.
        let even = Growth::new(1.0, (0.25, 0.5), 2.0);
        assert_eq!(even.power, 1.0);
        let found = flow_ends(&[even], 0.375);
        assert!(found.len() == 2 && (found[0] - 0.75).abs() < 1e-6 && found[1] == 1.0);
        // A small corner that yields from the start decides nothing.
        let corner = Growth::new(1e-4, (0.25, 1.0), 4.0);
        let found = flow_ends(&[even, corner], 0.375);
        assert!(found.len() == 2 && (found[0] - 0.75).abs() < 1e-2);
        // No part is longer than that.
        let found = flow_ends(&[even], 0.1);
        assert_eq!(found.len(), 6);
        // The root of the load: yield at a quarter.
        let root = Growth::new(1.0, (0.25, 1.0), 2.0);
        assert!(flow_ends(&[root], 1.0)[0] > 0.25);
    }

    #[test]
    fn nothing_that_flows_is_no_plan() {
        assert!(flow_ends(&[Growth::new(1.0, (0.25, 0.1), 0.9)], 0.3).is_empty());
        assert!(flow_ends(&[], 0.3).is_empty());
        // What does not grow is no number to be wrong about.
        assert!(flow_ends(&[Growth::new(1.0, (1.0, 0.0), 0.0)], 0.3).is_empty());
    }
}
