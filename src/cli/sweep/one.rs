//! One row of a sweep, in a process of its own: what a sweep starts here, and a task of a job array.

use super::arguments::SweepArgs;
use crate::cli::console::{Console, LEGEND};
use crate::cli::output::say;
use crate::cli::status::ExitStatus;
use crate::cli::threads::set_threads;
use crate::model::state::State;
use crate::product::sweep::{self, Sweep, SweepError, SweepFolder};
use crate::render::digest::digest;
use crate::solver::solve::{Iteration, Observer};
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Runs row `number`, printing the digest that `brinell run` prints.
pub fn run(
    args: &SweepArgs,
    sweep: &Sweep,
    place: &SweepFolder,
    number: usize,
) -> Result<ExitStatus, SweepError> {
    let row = sweep.row(number)?;
    set_threads(args.threads);
    let mut observer = StoppableConsole {
        console: Console::new(false),
        input_ended: watch_input(args.leash),
    };
    say(&format!("row {number}: {}\n{LEGEND}\n", row.said()));
    let ended = sweep::run_row(row, place, args.resume, &mut observer);
    observer.console.finish();
    let (record, outcome) = ended?;
    if let Some((outcome, missed)) = outcome {
        say(&digest(&outcome.summary, &missed));
    }
    say(&format!("{} {}", record.status.name(), record.message));
    Ok(match record.status {
        sweep::RowStatus::Done => ExitStatus::Done,
        sweep::RowStatus::LimitsMissed => ExitStatus::Failed,
        sweep::RowStatus::BadInput => ExitStatus::BadInput,
        sweep::RowStatus::NotConverged | sweep::RowStatus::Crashed => ExitStatus::NotConverged,
        sweep::RowStatus::Interrupted => ExitStatus::Interrupted,
    })
}

/// A flag that is set when standard input ends, if that is asked for: whoever holds the other end has
/// closed it or died, in whatever way.
fn watch_input(wanted: bool) -> Arc<AtomicBool> {
    let input_ended = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&input_ended);
    if wanted {
        std::thread::spawn(move || {
            let _ = std::io::stdin().read_to_end(&mut Vec::new());
            flag.store(true, Ordering::Relaxed);
        });
    }
    input_ended
}

/// The console, which the end of standard input stops as Ctrl-C does.
struct StoppableConsole {
    console: Console,
    input_ended: Arc<AtomicBool>,
}

impl Observer for StoppableConsole {
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
        self.console.cancelled() || self.input_ended.load(Ordering::Relaxed)
    }
}
