//! When a checkpoint is written: seldom enough to cost little, and always before a run ends.

use super::checkpoint::Checkpoint;
use crate::ground::file::FileError;
use crate::solver::solve::Restart;
use std::time::{Duration, Instant};

/// A checkpoint holds the ends of all steps so far: writing it after each of many steps takes longer than solving them. So it
/// waits for this many times as long as the one before took to write. Whoever kills a run loses no more than that.
const PATIENCE: u32 = 20;

/// The checkpoint of a run, and what is still to be written of it.
pub struct Saving {
    checkpoint: Checkpoint,
    /// The last increment, where the file is of an earlier one.
    waiting: Option<Restart>,
    pace: Pace,
}

impl Saving {
    pub fn new(checkpoint: Checkpoint) -> Self {
        Self {
            checkpoint,
            waiting: None,
            pace: Pace::default(),
        }
    }

    /// Takes `restart`, and writes it where that is due.
    ///
    /// # Errors
    /// [`FileError::Write`]; what was there is then still there.
    pub fn take(&mut self, restart: Restart) -> Result<(), FileError> {
        self.waiting = Some(restart);
        if self.pace.is_due(Instant::now()) {
            self.write()?;
        }
        Ok(())
    }

    /// Writes what waits. To be called however a run ends: the next one goes on after the last increment.
    ///
    /// # Errors
    /// [`FileError::Write`]; what was there is then still there.
    pub fn write(&mut self) -> Result<(), FileError> {
        let Some(restart) = self.waiting.take() else {
            return Ok(());
        };
        let start = Instant::now();
        self.checkpoint.write(&restart)?;
        self.pace = Pace::after(start, Instant::now());
        Ok(())
    }
}

/// When the next one is due; the first is at once.
#[derive(Debug, Clone, Copy, Default)]
struct Pace {
    due: Option<Instant>,
}

impl Pace {
    /// One was begun at `start` and is there at `end`.
    fn after(start: Instant, end: Instant) -> Self {
        let took: Duration = end - start;
        Self {
            due: Some(end + PATIENCE * took),
        }
    }

    fn is_due(self, now: Instant) -> bool {
        self.due.is_none_or(|due| now >= due)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_is_written_at_once_and_the_next_after_twenty_times_as_long() {
        let start = Instant::now();
        assert!(Pace::default().is_due(start));
        let end = start + Duration::from_millis(50);
        let pace = Pace::after(start, end);
        assert!(!pace.is_due(end));
        assert!(!pace.is_due(end + Duration::from_millis(999)));
        assert!(pace.is_due(end + Duration::from_secs(1)));
    }
}
