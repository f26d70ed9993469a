//! What a running sweep shows on the terminal: a line for each row that has ended, and a bar.

use crate::cli::output::say;
use crate::cli::signals::set_on_ctrl_c;
use crate::product::sweep::{RowRecord, Sweep, Watcher};
use crate::render::text::significant;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::Value;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

pub struct SweepProgress {
    bar: ProgressBar,
    stop: Arc<AtomicBool>,
    quiet: bool,
    all: usize,
    failed: bool,
}

impl SweepProgress {
    /// Ctrl-C stops the sweep, a second one at once.
    pub fn new(sweep: &Sweep, quiet: bool) -> Self {
        let all = sweep.rows.len();
        let bar = ProgressBar::new(all as u64);
        if let Ok(style) =
            ProgressStyle::with_template("{elapsed_precise} {wide_bar} {pos} of {len} rows")
        {
            bar.set_style(style);
        }
        Self {
            bar,
            stop: set_on_ctrl_c(),
            quiet,
            all,
            failed: false,
        }
    }

    /// Takes the bar off the terminal.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Has a row ended without an answer?
    pub fn failed(&self) -> bool {
        self.failed
    }

    pub fn say(&self, text: &str) {
        if !self.quiet {
            self.bar.suspend(|| say(text));
        }
    }

    /// Says what came of a row.
    pub fn line(&mut self, record: &RowRecord) {
        let figure = |name: &str| {
            let [value, bar] = [name, &format!("{name}_error")].map(|name| record.number(name));
            match (value, bar) {
                (None, _) => "-".to_owned(),
                (Some(value), Some(bar)) => {
                    format!("{} ± {}", significant(value, 4), significant(bar, 2))
                }
                (Some(value), None) => format!("{} not resolved", significant(value, 4)),
            }
        };
        let word = |(key, value): &(String, Value)| {
            let value = value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned);
            format!("{} {value}", key.rsplit('.').next().unwrap_or(key))
        };
        let parameters: Vec<String> = record.parameters.iter().map(word).collect();
        let answer = if record.figures.is_empty() {
            record.message.clone()
        } else {
            format!(
                "Mises {:18}  utilisation {:19}",
                figure("mises_nodal"),
                figure("utilisation")
            )
        };
        self.say(&format!(
            "{:4}  {:13} {:8.1} s  {answer}  {}",
            record.row,
            record.status.name(),
            record.seconds,
            parameters.join(", ")
        ));
    }
}

impl Watcher for SweepProgress {
    fn ended(&mut self, record: &RowRecord, left: usize) {
        self.failed |= record.figures.is_empty();
        self.bar
            .set_position((self.all - left.min(self.all)) as u64);
        self.line(record);
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
