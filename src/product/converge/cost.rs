//! What a piece of work costs: seconds on the clock, seconds of the processors, memory.

use crate::ground::memory;
use crate::product::job::{Clock, Spent};
use serde::Serialize;

/// What a level cost.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Cost {
    /// Seconds on the clock.
    pub wall_s: f64,
    /// Seconds of all threads of the process together.
    pub cpu_s: f64,
    /// Largest resident memory of the process, what it held before included; `None` where the
    /// system does not tell.
    pub peak_memory_bytes: Option<u64>,
    /// Is the peak that of this level? Else it is that of the process since it began.
    pub peak_is_own: bool,
}

/// Measures from its start to its stop.
#[derive(Debug)]
pub struct Meter {
    clock: Clock,
    own: bool,
}

impl Meter {
    pub fn start() -> Self {
        Self {
            own: forget_peak(),
            clock: Clock::start(),
        }
    }

    pub fn stop(&self) -> Cost {
        let Spent { wall_s, cpu_s } = self.clock.spent();
        Cost {
            wall_s,
            cpu_s: cpu_s.unwrap_or(f64::NAN),
            peak_memory_bytes: memory::peak(),
            peak_is_own: self.own,
        }
    }
}

/// Begins the count of Linux's largest resident memory anew; `false` where that is not allowed.
fn forget_peak() -> bool {
    std::fs::write("/proc/self/clear_refs", "5").is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_takes_time_and_memory() {
        let meter = Meter::start();
        let block = vec![1u8; 64 << 20];
        let sum: u64 = block.iter().map(|b| u64::from(*b)).sum();
        let cost = meter.stop();
        assert_eq!(sum, 64 << 20);
        assert!(cost.wall_s > 0.0 && cost.cpu_s > 0.0, "{cost:?}");
        assert!(cost.peak_memory_bytes.is_none_or(|b| b > 64 << 20));
    }
}
