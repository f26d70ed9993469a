//! What was measured at one size, and the file that keeps it: a line of JSON a size.

use crate::sizes::{Model, Size};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A size that was run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    pub model: Model,
    pub size: String,
    pub scale: f64,
    pub threads: usize,
    pub build: String,
    /// gmsh and compression, in a process of its own.
    pub meshing_s: f64,
    /// The run, or why there is none.
    pub run: Result<Run, String>,
}

/// A run that came to its end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    pub unknowns: f64,
    pub kept_unknowns: f64,
    pub elements: f64,
    pub iterations: f64,
    pub factorisations: f64,
    pub krylov_directions: f64,
    pub factor_entries: f64,
    /// Of the whole process.
    pub wall_s: f64,
    pub cpu_s: f64,
    pub peak_memory_bytes: f64,
    /// From the start of the process to its first work.
    pub start_s: f64,
    /// Reading the mesh.
    pub mesh_s: f64,
    pub solve_s: f64,
    pub solve_cpu_s: f64,
    pub write_s: f64,
    /// Parts of `solve_s`.
    pub phases: BTreeMap<String, f64>,
}

impl Run {
    /// CPU seconds of the solution for each Newton iteration.
    pub fn cpu_per_iteration(&self) -> f64 {
        self.solve_cpu_s / self.iterations.max(1.0)
    }
}

/// Names a build of the program: a hash of its file.
pub fn build(binary: &Path) -> io::Result<String> {
    let mut hasher = DefaultHasher::new();
    hasher.write(&std::fs::read(binary)?);
    Ok(format!("{:016x}", hasher.finish()))
}

/// All records so far.
#[derive(Debug)]
pub struct Store {
    path: PathBuf,
    records: Vec<Record>,
}

impl Store {
    /// Reads the records at `path`; lines of another format are passed over.
    pub fn open(path: &Path) -> io::Result<Self> {
        let text = match std::fs::read_to_string(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            other => other?,
        };
        let records = text.lines().filter_map(|l| serde_json::from_str(l).ok());
        Ok(Self {
            path: path.to_owned(),
            records: records.collect(),
        })
    }

    /// The latest complete run of this size, of `build` where one is given.
    pub fn find(
        &self,
        model: Model,
        size: &Size,
        threads: usize,
        build: Option<&str>,
    ) -> Option<&Record> {
        self.records.iter().rev().find(|r| {
            r.model == model
                && r.size == size.label
                && r.scale == model.scale(size.unknowns)
                && r.threads == threads
                && r.run.is_ok()
                && build.is_none_or(|b| b == r.build)
        })
    }

    pub fn push(&mut self, record: Record) -> io::Result<()> {
        let mut line = serde_json::to_string(&record)?;
        line.push('\n');
        let mut options = std::fs::OpenOptions::new();
        let mut file = options.create(true).append(true).open(&self.path)?;
        file.write_all(line.as_bytes())?;
        self.records.push(record);
        Ok(())
    }
}
