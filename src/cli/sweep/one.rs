//! One row of a sweep, in a process of its own: what a sweep starts here, and a task of a job array.

use super::SweepArgs;
use crate::cli::console::{Console, LEGEND};
use crate::cli::run::set_threads;
use crate::cli::{Status, say};
use crate::model::state::State;
use crate::product::sweep::{self, Place, Sweep, SweepError};
use crate::render::terminal;
use crate::solver::solve::{Iteration, Observer};
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Runs row `number`, printing what `brinell run` prints.
pub fn run(
    args: &SweepArgs,
    sweep: &Sweep,
    place: &Place,
    number: usize,
) -> Result<Status, SweepError> {
    let row = sweep.row(number)?;
    set_threads(args.threads);
    let mut observer = Leashed {
        console: Console::new(false),
        let_go: leash(args.leash),
    };
    say(&format!("row {number}: {}\n{LEGEND}\n", row.said()));
    let ended = sweep::run_row(row, place, args.resume, &mut observer);
    observer.console.finish();
    let (record, outcome) = ended?;
    if let Some(outcome) = outcome {
        say(&terminal::render(&outcome.summary, false));
    }
    say(&format!("{} {}", record.status.name(), record.message));
    Ok(match record.status {
        sweep::Status::Done => Status::Done,
        sweep::Status::LimitsMissed => Status::Failed,
        sweep::Status::BadInput => Status::BadInput,
        sweep::Status::NotConverged | sweep::Status::Crashed => Status::NotConverged,
        sweep::Status::Interrupted => Status::Interrupted,
    })
}

/// A flag that is set when standard input ends, if that is asked for: whoever holds the other end has
/// closed it or died, in whatever way.
fn leash(wanted: bool) -> Arc<AtomicBool> {
    let let_go = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&let_go);
    if wanted {
        std::thread::spawn(move || {
            let _ = std::io::stdin().read_to_end(&mut Vec::new());
            flag.store(true, Ordering::Relaxed);
        });
    }
    let_go
}

/// The console, and the leash beside Ctrl-C.
struct Leashed {
    console: Console,
    let_go: Arc<AtomicBool>,
}

impl Observer for Leashed {
    fn iteration(&mut self, iteration: &Iteration) {
        self.console.iteration(iteration);
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.console.increment(state)
    }

    fn message(&mut self, text: &str) {
        self.console.message(text);
    }

    fn cancelled(&self) -> bool {
        self.console.cancelled() || self.let_go.load(Ordering::Relaxed)
    }
}
