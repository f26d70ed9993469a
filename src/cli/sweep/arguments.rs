//! The arguments of `brinell sweep`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Who runs the rows, where this machine does not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Scheduler {
    Slurm,
}

/// Many cases from one: a table of parameters to a row of results each, here or by Slurm.
///
/// The sweep file names a case, and what is varied: every combination of a grid, the rows of a
/// list, or those of a CSV file, under keys of the case such as bearing.load. All rows are read before the
/// first one is run. Each runs in a process and a folder of its own; table.csv and table.jsonl have a
/// line for each that has ended, and a plot over each parameter is drawn.
#[derive(Debug, Args)]
pub struct SweepArgs {
    /// The sweep file.
    pub sweep: PathBuf,
    /// Folder for the table and the runs; by default results/ and the name of the sweep file.
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Go on with an earlier sweep into the same folder: finished rows stay as they are, half-done
    /// ones go on after their last increment. A row whose case has changed is run anew.
    #[arg(long)]
    pub resume: bool,
    /// Runs at a time [default: one a core, as far as memory goes].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Memory for all runs together, such as "6 GB": the sum of their estimates stays below
    /// [default: four fifths of what is free].
    #[arg(long, value_parser = bytes)]
    pub memory: Option<f64>,
    /// Threads for all runs together [default: one a core].
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
    /// Run nothing, but write a job array that does, one task a row; sbatch submits it.
    #[arg(long, value_name = "SCHEDULER", conflicts_with_all = ["collect", "row"])]
    pub emit: Option<Scheduler>,
    /// Run nothing, but gather the rows that have ended into the table.
    #[arg(long, conflicts_with = "row")]
    pub collect: bool,
    /// Run this row only, counted from 1, as --emit has prepared it: what a task does.
    #[arg(long, value_name = "N")]
    pub row: Option<usize>,
    /// Stop when standard input ends.
    #[arg(long, hide = true)]
    pub leash: bool,
    /// Print no line for each row.
    #[arg(long, short)]
    pub quiet: bool,
}

/// Bytes from a text such as `6 GB`, `800MB` or `2 GiB`.
fn bytes(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let end = text
        .find(|c: char| c.is_ascii_alphabetic())
        .unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let size = match unit.to_ascii_lowercase().as_str() {
        "mb" | "m" => 1e6,
        "gb" | "g" => 1e9,
        "tb" | "t" => 1e12,
        "mib" => f64::powi(1024.0, 2),
        "gib" => f64::powi(1024.0, 3),
        "tib" => f64::powi(1024.0, 4),
        _ => return Err("a number and MB, GB or TB are wanted, such as \"6 GB\"".to_owned()),
    };
    let number = number.trim().parse::<f64>().ok();
    let number = number.filter(|n| *n > 0.0 && n.is_finite());
    number
        .map(|n| n * size)
        .ok_or_else(|| "the number must be positive".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_read_with_its_unit() {
        assert_eq!(bytes("6 GB"), Ok(6e9));
        assert_eq!(bytes("0.5gib"), Ok(536_870_912.0));
        for wrong in ["6", "GB", "-1 GB", "nan MB", "6 kip"] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }
}
