//! CalculiX: installed where it is missing, run on a deck, and read.

use crate::frd::{self, Fields};
use crate::process::{self, Cost};
use std::path::Path;
use std::process::Command;

/// What a run of CalculiX comes to.
#[derive(Debug, Clone)]
pub struct Run {
    pub cost: Cost,
    pub equations: usize,
    pub iterations: usize,
    pub fields: Fields,
}

/// The version, such as `2.20`; installs Debian's package where there is none.
///
/// # Errors
/// Where there is none and it cannot be installed.
pub fn ensure() -> Result<String, String> {
    if let Some(version) = version() {
        return Ok(version);
    }
    println!("ccx is missing: installing Debian's calculix-ccx");
    // Where this is no superuser, by sudo without a question.
    let sudo = Command::new("id")
        .arg("-u")
        .output()
        .is_ok_and(|id| id.stdout != b"0\n");
    for words in [
        &["update", "-qq"][..],
        &["install", "-y", "-qq", "calculix-ccx"],
    ] {
        let mut command = Command::new(if sudo { "sudo" } else { "apt-get" });
        if sudo {
            command.args(["-n", "apt-get"]);
        }
        // A failure shows below.
        let _ = command
            .args(words)
            .env("DEBIAN_FRONTEND", "noninteractive")
            .status();
    }
    version().ok_or_else(|| "there is no ccx: install CalculiX (Debian: calculix-ccx)".into())
}

fn version() -> Option<String> {
    let output = Command::new("ccx").arg("-v").output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.split_whitespace().last().map(str::to_string)
}

/// Runs the deck `<folder>/<name>.inp` on `threads` threads, `times` times, for the median.
///
/// # Errors
/// Where it fails or ends before its last step is done.
pub fn run(
    folder: &Path,
    name: &str,
    nodes: usize,
    threads: usize,
    times: usize,
) -> Result<Run, String> {
    let log = folder.join("ccx.log");
    let cost = process::median(times, || {
        let mut command = Command::new("ccx");
        command.arg(name).current_dir(folder);
        command.env("OMP_NUM_THREADS", threads.to_string());
        process::run(&mut command, &log)
    })?;
    let text = |ending: &str| {
        let path = folder.join(format!("{name}.{ending}"));
        std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))
    };
    let said = std::fs::read_to_string(&log).unwrap_or_default();
    if !said.contains("Job finished") {
        return Err(format!("ccx did not finish {name}; see {}", log.display()));
    }
    let steps = text("inp")?
        .lines()
        .filter(|l| l.starts_with("*STEP"))
        .count();
    let status = text("sta")?;
    let reached = status
        .lines()
        .filter_map(|l| l.split_whitespace().nth(4)?.parse::<f64>().ok());
    if reached.fold(0.0, f64::max) < steps as f64 - 1e-6 {
        return Err(format!("ccx gave up in {name}; see {}", log.display()));
    }
    let is_iteration = |l: &&str| l.split_whitespace().all(|w| w.parse::<f64>().is_ok());
    let iterations = text("cvg")?
        .lines()
        .filter(|l| !l.is_empty())
        .filter(is_iteration)
        .count();
    let mut after = said.split("number of equations").skip(1);
    let equations = after
        .next()
        .and_then(|t| t.split_whitespace().next()?.parse().ok());
    Ok(Run {
        cost,
        equations: equations.unwrap_or(0),
        iterations,
        fields: frd::read(&folder.join(format!("{name}.frd")), nodes)?,
    })
}

impl Fields {
    /// Largest Mises stress at the nodes for which `wanted` holds.
    pub fn peak_mises(&self, wanted: impl Fn(usize) -> bool) -> f64 {
        let nodes = (0..self.stress.len()).filter(|n| wanted(*n));
        let mises = nodes.map(|n| brinell::model::material::mises(&self.stress[n]));
        mises.fold(0.0, f64::max)
    }

    /// Largest contact pressure at a node.
    pub fn peak_pressure(&self) -> f64 {
        self.pressure.iter().copied().fold(0.0, f64::max)
    }
}
