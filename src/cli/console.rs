//! What a running solution shows on the terminal: a line an iteration, a bar for the load.

use super::output::say;
use super::signals::set_on_ctrl_c;
use crate::model::state::State;
use crate::solver::solve::{Iteration, Observer};
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

pub struct Console {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
    quiet: bool,
    lines: usize,
}

impl Console {
    /// Shows iterations unless `quiet`. Ctrl-C or SIGTERM stops between iterations, a second one at once: every
    /// file is then whole or not there.
    pub fn new(quiet: bool) -> Self {
        let bar = ProgressBar::new(1000);
        if let Ok(style) = ProgressStyle::with_template("{elapsed_precise} {wide_bar} {msg}") {
            bar.set_style(style);
        }
        Self {
            bar,
            stop: set_on_ctrl_c(),
            quiet,
            lines: 0,
        }
    }

    /// Was Ctrl-C pressed, or SIGTERM sent?
    pub fn interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Takes the bar off the terminal.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn line(&self, text: &str) {
        if !self.quiet {
            self.bar.suspend(|| say(text));
        }
    }
}

impl Observer for Console {
    fn iteration(&mut self, i: &Iteration) {
        if self.lines.is_multiple_of(24) {
            self.line(
                "  load   it  residual    energy  active  stick   slip changed  violation  \
                 flowing  solve  step",
            );
        }
        self.lines += 1;
        let solve = format!("{}{}", i.directions, if i.refactored { " new" } else { "" });
        self.line(&format!(
            "{:6.3} {:4} {:9.2e} {:9.2e} {:7} {:6} {:6} {:7} {:10.2e} {:8} {:>6} {:5.2}",
            i.step as f64 + i.time,
            i.iteration,
            i.residual,
            i.energy,
            i.active,
            i.sticking,
            i.slipping,
            i.changed,
            i.penetration,
            i.flowing,
            solve,
            i.line_search,
        ));
    }

    fn increment(&mut self, state: &State) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.bar.set_position((1000.0 * state.time) as u64);
        self.bar.set_message(format!("step {}", state.step + 1));
        Ok(())
    }

    fn message(&mut self, text: &str) {
        self.line(text);
    }

    fn cancelled(&self) -> bool {
        self.interrupted()
    }
}

/// The legend of the iteration lines.
pub const LEGEND: &str = "\
load: step and share of it; residual: unbalanced force over applied force; energy: work of the \
correction; active, stick, slip: contact nodes; changed: statuses that changed; violation: largest \
miss of a contact condition over the largest displacement; flowing: integration points; solve: \
Krylov directions (new: a new factor); step: line search";
