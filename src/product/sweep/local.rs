//! A sweep on this machine: a process for each row, as many at a time as the budget allows.
//!
//! A row that crashes takes nothing along. Each run holds the other end of a pipe and stops, at its
//! checkpoint, when that closes: when the sweep is stopped, and when it is killed.

use super::budget::SweepBudget;
use super::children::Children;
use super::error::SweepError;
use super::one;
use super::place::SweepFolder;
use super::prepare::{Need, prepare};
use super::record::{RowRecord, RowStatus};
use super::rows::{Sweep, SweepRow};
use super::table;
use std::collections::{BTreeMap, VecDeque};
use std::process::Child;
use std::time::Duration;

/// Is told how a sweep goes on, and may stop it.
pub trait Watcher {
    /// After each row that has ended; `left` have not.
    fn ended(&mut self, record: &RowRecord, left: usize);
    /// Asked all the time.
    fn stopped(&self) -> bool;
}

/// At most so many rows are prepared ahead of those that run, to find one that fits beside them.
const ROWS_AHEAD: usize = 4;

/// Runs the rows of `sweep` into `place`; with `resume` those that have not ended yet, and half-done
/// ones from where they were. The table is written after each of them. Comes back with what is known
/// of each row, in order: of fewer where the sweep was stopped.
///
/// # Errors
/// [`SweepError`] where the sweep cannot go on. A row that fails stops nothing.
pub fn run(
    sweep: &Sweep,
    place: &SweepFolder,
    budget: SweepBudget,
    resume: bool,
    watcher: &mut dyn Watcher,
) -> Result<Vec<RowRecord>, SweepError> {
    let _lock = place.lock()?;
    let records = RowRecord::all_final(sweep, place, resume)?;
    let left = sweep
        .rows
        .iter()
        .filter(|row| !records.contains_key(&row.number));
    let mut run = LocalRun {
        children: Children::new(sweep, place, resume)?,
        sweep,
        place,
        budget,
        watcher,
        pending: left.collect(),
        ready: Vec::new(),
        running: Vec::new(),
        records,
    };
    run.all()?;
    Ok(run.records.into_values().collect())
}

struct LocalRun<'s> {
    children: Children<'s>,
    sweep: &'s Sweep,
    place: &'s SweepFolder,
    budget: SweepBudget,
    watcher: &'s mut dyn Watcher,
    /// Not prepared yet; prepared; begun.
    pending: VecDeque<&'s SweepRow>,
    ready: Vec<(&'s SweepRow, Need)>,
    running: Vec<Running<'s>>,
    records: BTreeMap<usize, RowRecord>,
}

struct Running<'s> {
    row: &'s SweepRow,
    need: Need,
    process: Child,
}

impl<'s> LocalRun<'s> {
    fn all(&mut self) -> Result<(), SweepError> {
        const PAUSE: Duration = Duration::from_millis(10);
        self.write()?;
        loop {
            self.reap()?;
            if self.watcher.stopped() {
                self.pending.clear();
                self.ready.clear();
                for run in &mut self.running {
                    // Closes the pipe.
                    run.process.stdin = None;
                }
            }
            self.start()?;
            if self.running.is_empty() && self.pending.is_empty() && self.ready.is_empty() {
                return Ok(());
            }
            std::thread::sleep(PAUSE);
        }
    }

    /// Starts what there is room for, the first rows first.
    fn start(&mut self) -> Result<(), SweepError> {
        while self.running.len() < self.budget.jobs {
            let running: Vec<Need> = self.running.iter().map(|run| run.need).collect();
            let allowed = |(_, need): &(&SweepRow, Need)| self.budget.allows(&running, need.memory);
            if let Some(at) = self.ready.iter().position(allowed) {
                let (row, need) = self.ready.remove(at);
                self.launch(row, need)?;
            } else if self.ready.len() < ROWS_AHEAD && !self.watcher.stopped() {
                let Some(row) = self.pending.pop_front() else {
                    return Ok(());
                };
                self.prepare(row)?;
            } else {
                return Ok(());
            }
        }
        Ok(())
    }

    fn prepare(&mut self, row: &'s SweepRow) -> Result<(), SweepError> {
        let need = match prepare(self.sweep, row, self.place) {
            Ok(need) => need,
            Err(error) => {
                let record = one::failed(row, &error, self.watcher.stopped());
                return self.failed(row, record);
            }
        };
        if self.budget.ever_allows(need.memory) {
            self.ready.push((row, need));
            return Ok(());
        }
        let gb = |bytes: f64| format!("{:.2} GB", 1e-9 * bytes);
        let message = format!(
            "{} unknowns need about {}, and the sweep may take {} (--memory)",
            need.unknowns,
            gb(need.memory),
            gb(self.budget.memory)
        );
        self.failed(row, RowRecord::without(row, RowStatus::BadInput, message))
    }

    fn launch(&mut self, row: &'s SweepRow, need: Need) -> Result<(), SweepError> {
        let left = self.pending.len() + self.ready.len() + self.running.len() + 1;
        let threads = self.budget.threads_of(need.memory, left);
        let process = self.children.start(row, threads)?;
        self.running.push(Running { row, need, process });
        Ok(())
    }

    /// Takes in what has ended.
    fn reap(&mut self) -> Result<(), SweepError> {
        let mut at = 0;
        while at < self.running.len() {
            let ended = self.running[at].process.try_wait();
            match ended.map_err(|error| SweepError::Start { error })? {
                None => at += 1,
                Some(status) => {
                    let row = self.running.remove(at).row;
                    let record = self.children.what_came(row, status)?;
                    self.ended(record)?;
                }
            }
        }
        Ok(())
    }

    /// A row that did not get as far as its own process.
    fn failed(&mut self, row: &SweepRow, record: RowRecord) -> Result<(), SweepError> {
        record.write(self.place, row)?;
        self.ended(record)
    }

    fn ended(&mut self, record: RowRecord) -> Result<(), SweepError> {
        let left = self.pending.len() + self.ready.len() + self.running.len();
        self.watcher.ended(&record, left);
        self.records.insert(record.row, record);
        self.write()
    }

    fn write(&self) -> Result<(), SweepError> {
        table::write(self.place, &self.sweep.columns, self.records.values())
    }
}
