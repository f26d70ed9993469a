//! Brinell: the program as a process, and what its summary says.

use crate::process::{self, Cost};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// A run of the program.
pub struct Run {
    pub cost: Cost,
    pub summary: Value,
}

/// `brinell` with these words.
pub fn command<'a>(words: impl IntoIterator<Item = &'a str>) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brinell"));
    command.args(words);
    command
}

/// Runs `case` into `out` on `threads` threads, `times` times, for the median.
///
/// # Errors
/// Where the program fails or writes no summary.
pub fn run(
    case: &Path,
    out: &Path,
    more: &[&str],
    threads: usize,
    times: usize,
) -> Result<Run, String> {
    std::fs::create_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    let threads = threads.to_string();
    let cost = process::median(times, || {
        let mut command = command(["run"]);
        command.arg(case).arg("--out").arg(out).args(more);
        command.args(["--threads", &threads, "--quiet"]);
        process::run(&mut command, &out.join("brinell.log"))
    })?;
    let summary = read(&out.join("summary.json"))?;
    Ok(Run { cost, summary })
}

/// Runs `case` to a target into `out`: what all levels cost, and what the last one says.
///
/// # Errors
/// Where the program fails or misses the target.
pub fn run_levels(
    case: &Path,
    out: &Path,
    more: &[&str],
    threads: usize,
) -> Result<(Cost, Value), String> {
    std::fs::create_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    let mut command = command(["run"]);
    command.arg(case).arg("--out").arg(out).args(more);
    command.args(["--threads", &threads.to_string(), "--quiet"]);
    let cost = process::run(&mut command, &out.join("brinell.log"))?;
    let levels = (0..).map(|level| out.join(format!("level-{level}")).join("summary.json"));
    let last = levels.take_while(|path| path.exists()).last();
    let last = last.ok_or("no level wrote a summary")?;
    Ok((cost, read(&last)?))
}

fn read(path: &Path) -> Result<Value, String> {
    let bytes = std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
    serde_json::from_slice(&bytes).map_err(|e| format!("{}: {e}", path.display()))
}

impl Run {
    /// The number at `pointer`, such as `/descent`; "not a number" where there is none.
    pub fn number(&self, pointer: &str) -> f64 {
        self.summary
            .pointer(pointer)
            .and_then(Value::as_f64)
            .unwrap_or(f64::NAN)
    }

    /// The largest of the numbers at `pointer` in all entries of `table`.
    pub fn largest(&self, table: &str, pointer: &str) -> f64 {
        let entries = self.summary.get(table).and_then(Value::as_object);
        let values = entries.into_iter().flat_map(|e| e.values());
        let values = values.filter_map(|v| v.pointer(pointer)?.as_f64());
        values.fold(f64::NAN, f64::max)
    }
}

/// Writes `case` as a deck into `folder`.
///
/// # Errors
/// Where the program fails.
pub fn export(case: &Path, folder: &Path, more: &[&str]) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut command = command(["export"]);
    command
        .arg(case)
        .args(["--format", "inp", "--out"])
        .arg(folder)
        .args(more);
    process::run(&mut command, &folder.join("export.log")).map(|_| ())
}
