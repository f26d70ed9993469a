//! A sweep on this machine: a process for each row, as many at a time as the budget allows.
//!
//! A row that crashes takes nothing along. Each run holds the other end of a pipe and stops, at its
//! checkpoint, when that closes: when the sweep is stopped, and when it is killed.

use super::budget::Budget;
use super::children::Children;
use super::error::SweepError;
use super::one;
use super::place::Place;
use super::prepare::{Need, prepare};
use super::record::{Record, Status};
use super::rows::{Row, Sweep};
use super::table;
use std::collections::{BTreeMap, VecDeque};
use std::process::Child;
use std::time::Duration;

/// Is told how a sweep goes on, and may stop it.
pub trait Watcher {
    /// After each row that has ended; `left` have not.
    fn ended(&mut self, record: &Record, left: usize);
    /// Asked all the time.
    fn stopped(&self) -> bool;
}

/// Rows that are prepared ahead of those that run, to find one that fits beside them.
const AHEAD: usize = 4;

/// Runs the rows of `sweep` into `place`; with `resume` those that have not ended yet, and half-done
/// ones from where they were. The table is written after each of them. Comes back with what is known
/// of each row, in order: of fewer where the sweep was stopped.
///
/// # Errors
/// [`SweepError`] where the sweep cannot go on. A row that fails stops nothing.
pub fn run(
    sweep: &Sweep,
    place: &Place,
    budget: Budget,
    resume: bool,
    watcher: &mut dyn Watcher,
) -> Result<Vec<Record>, SweepError> {
    let _lock = place.lock()?;
    let records = Record::all_final(sweep, place, resume)?;
    let left = sweep
        .rows
        .iter()
        .filter(|row| !records.contains_key(&row.number));
    let mut run = Run {
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

struct Run<'s> {
    children: Children<'s>,
    sweep: &'s Sweep,
    place: &'s Place,
    budget: Budget,
    watcher: &'s mut dyn Watcher,
    /// Not prepared yet; prepared; begun.
    pending: VecDeque<&'s Row>,
    ready: Vec<(&'s Row, Need)>,
    running: Vec<Running<'s>>,
    records: BTreeMap<usize, Record>,
}

struct Running<'s> {
    row: &'s Row,
    need: Need,
    process: Child,
}

impl<'s> Run<'s> {
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
            let allowed = |(_, need): &(&Row, Need)| self.budget.allows(&running, need.memory);
            if let Some(at) = self.ready.iter().position(allowed) {
                let (row, need) = self.ready.remove(at);
                self.launch(row, need)?;
            } else if self.ready.len() < AHEAD && !self.watcher.stopped() {
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

    fn prepare(&mut self, row: &'s Row) -> Result<(), SweepError> {
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
        self.failed(row, Record::without(row, Status::BadInput, message))
    }

    fn launch(&mut self, row: &'s Row, need: Need) -> Result<(), SweepError> {
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
    fn failed(&mut self, row: &Row, record: Record) -> Result<(), SweepError> {
        record.write(self.place, row)?;
        self.ended(record)
    }

    fn ended(&mut self, record: Record) -> Result<(), SweepError> {
        let left = self.pending.len() + self.ready.len() + self.running.len();
        self.watcher.ended(&record, left);
        self.records.insert(record.row, record);
        self.write()
    }

    fn write(&self) -> Result<(), SweepError> {
        table::write(self.place, &self.sweep.columns, self.records.values())
    }
}
