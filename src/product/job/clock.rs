//! Seconds of a part of a job. Reported, never decided upon.

use cpu_time::ProcessTime;
use std::time::Instant;

/// What has been spent since the start.
#[derive(Debug, Clone, Copy, Default)]
pub struct Spent {
    pub wall_s: f64,
    /// Of all threads together; `None` where the system does not tell.
    pub cpu_s: Option<f64>,
}

#[derive(Debug)]
pub struct Clock {
    wall: Instant,
    cpu: Option<ProcessTime>,
}

impl Clock {
    pub fn start() -> Self {
        Self {
            wall: Instant::now(),
            cpu: ProcessTime::try_now().ok(),
        }
    }

    pub fn spent(&self) -> Spent {
        let now = ProcessTime::try_now().ok();
        let cpu = self.cpu.zip(now).map(|(then, now)| {
            let spent = now.as_duration().saturating_sub(then.as_duration());
            spent.as_secs_f64()
        });
        Spent {
            wall_s: self.wall.elapsed().as_secs_f64(),
            cpu_s: cpu,
        }
    }
}

impl Spent {
    /// This and `other`, one after the other.
    pub fn plus(self, other: Self) -> Self {
        Self {
            wall_s: self.wall_s + other.wall_s,
            cpu_s: self.cpu_s.zip(other.cpu_s).map(|(a, b)| a + b),
        }
    }

    /// This without `part`.
    pub fn minus(self, part: Self) -> Self {
        Self {
            wall_s: self.wall_s - part.wall_s,
            cpu_s: self.cpu_s.zip(part.cpu_s).map(|(a, b)| a - b),
        }
    }
}
