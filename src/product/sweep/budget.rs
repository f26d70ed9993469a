//! What the runs of a sweep may take together, and who may start.

use super::prepare::Need;

/// What the runs may take together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepBudget {
    /// Runs at a time.
    pub jobs: usize,
    /// Threads, divided among the runs.
    pub threads: usize,
    /// Bytes.
    pub memory: f64,
}

impl SweepBudget {
    /// May a run that needs `memory` start beside those that run already?
    pub fn allows(&self, running: &[Need], memory: f64) -> bool {
        let taken: f64 = running.iter().map(|need| need.memory).sum();
        running.len() < self.jobs && taken + memory <= self.memory
    }

    /// Could it ever?
    pub fn ever_allows(&self, memory: f64) -> bool {
        memory <= self.memory
    }

    /// Threads of a run that needs `memory`, while `left` rows have not ended: as if the others were
    /// like it.
    pub fn threads_of(&self, memory: f64, left: usize) -> usize {
        let beside = (self.memory / memory.max(1.0)).floor().max(1.0);
        let together = self.jobs.min(left).min(beside as usize).max(1);
        (self.threads / together).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BUDGET: SweepBudget = SweepBudget {
        jobs: 4,
        threads: 8,
        memory: 10.0,
    };

    fn need(memory: f64) -> Need {
        Need {
            unknowns: 1,
            memory,
        }
    }

    #[test]
    fn estimates_stay_within_the_memory_and_runs_within_the_jobs() {
        assert!(BUDGET.allows(&[need(6.0)], 4.0));
        assert!(!BUDGET.allows(&[need(6.0)], 4.1));
        assert!(!BUDGET.allows(&[need(1.0); 4], 1.0));
        assert!(BUDGET.ever_allows(10.0) && !BUDGET.ever_allows(10.1));
    }

    #[test]
    fn threads_are_divided_among_the_runs_that_there_is_room_for() {
        assert_eq!(BUDGET.threads_of(1.0, 12), 2);
        // The last two have half of the machine each, and so has what fits twice.
        assert_eq!(BUDGET.threads_of(1.0, 2), 4);
        assert_eq!(BUDGET.threads_of(5.0, 12), 4);
        assert_eq!(BUDGET.threads_of(6.0, 12), 8);
        let crowded = SweepBudget {
            threads: 2,
            ..BUDGET
        };
        assert_eq!(crowded.threads_of(1.0, 12), 1);
    }
}
