//! One size: its case file, its mesh, its run.

use crate::kit::Failure;
use crate::process::{End, run as run_process};
use crate::record::{Record, Run};
use crate::sizes::{Model, Size};
use crate::{BINARY, ROOT, WORK};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// gmsh is given this long.
const MESHING: Duration = Duration::from_secs(1800);

/// Measures one size. A run that fails is a record, too.
pub fn run(
    model: Model,
    size: &Size,
    threads: usize,
    limit: Duration,
    build: &str,
) -> Result<Record, Failure> {
    let folder = Path::new(WORK).join(format!("{}-{}", model.name(), size.label));
    std::fs::create_dir_all(&folder)?;
    let scale = model.scale(size.unknowns);
    let case = write_case(model, scale, &folder)?;
    let mut mesh = Command::new(BINARY);
    mesh.arg("mesh").arg(&case);
    mesh.arg("--out").arg(folder.join("mesh.msh.gz"));
    let (end, meshing) = run_process(&mut mesh, &folder.join("mesh.log"), MESHING)?;
    let run = match end {
        End::Exit(0) => solve(&case, &folder, threads, limit)?,
        other => Err(format!("no mesh: {}", words(&other))),
    };
    Ok(Record {
        model,
        size: size.label.clone(),
        scale,
        threads,
        build: build.to_owned(),
        meshing_s: meshing.wall_s,
        run,
    })
}

/// The case of `model` with its elements scaled.
fn write_case(model: Model, scale: f64, folder: &Path) -> Result<PathBuf, Failure> {
    let text = std::fs::read_to_string(Path::new(ROOT).join(model.case()))?;
    let mut case: toml::Table = text.parse()?;
    let mesh = case.get_mut("mesh").and_then(toml::Value::as_table_mut);
    let mesh = mesh.ok_or("the case has no [mesh]")?;
    mesh.insert("preset".into(), "h025".into());
    mesh.insert("scale".into(), scale.into());
    let path = folder.join("case.toml");
    std::fs::write(&path, case.to_string())?;
    Ok(path)
}

/// Solves the case; what it prints is in `run.log`.
fn solve(
    case: &Path,
    folder: &Path,
    threads: usize,
    limit: Duration,
) -> Result<Result<Run, String>, Failure> {
    let mut command = Command::new(BINARY);
    command
        .arg("run")
        .arg(case)
        .args(["--quiet", "--no-elastic-peaks"]);
    command.arg("--threads").arg(threads.to_string());
    command.arg("--out").arg(folder);
    let (end, usage) = run_process(&mut command, &folder.join("run.log"), limit)?;
    // 1: solved, a limit of the answer missed.
    if !matches!(end, End::Exit(0 | 1)) {
        let seconds = usage.wall_s;
        return Ok(Err(format!("{} after {seconds:.0} s", words(&end))));
    }
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json"))?)?;
    let number = |pointer: &str| {
        let value = summary.pointer(pointer).and_then(Value::as_f64);
        value.ok_or_else(|| format!("summary.json has no {pointer}"))
    };
    let phases = summary.pointer("/timing/phases").and_then(Value::as_object);
    let phases = phases.into_iter().flatten();
    Ok(Ok(Run {
        unknowns: number("/dofs")?,
        kept_unknowns: number("/kept_dofs")?,
        elements: number("/elements")?,
        iterations: number("/iterations")?,
        factorisations: number("/factorisations")?,
        krylov_directions: number("/krylov_directions")?,
        factor_entries: number("/factor_entries")?,
        wall_s: usage.wall_s,
        cpu_s: usage.cpu_s,
        peak_memory_bytes: usage.peak_memory_bytes as f64,
        start_s: (usage.wall_s - number("/timing/total_s")?).max(0.0),
        mesh_s: number("/timing/mesh_s")?,
        solve_s: number("/timing/solve_s")?,
        solve_cpu_s: number("/timing/solve_cpu_s")?,
        write_s: number("/timing/write_s")?,
        phases: phases
            .filter_map(|(name, v)| Some((name.clone(), v.as_f64()?)))
            .collect(),
    }))
}

fn words(end: &End) -> String {
    match end {
        End::Exit(3) => "not converged".into(),
        End::Exit(status) => format!("exit status {status}"),
        End::Signal(9) => "killed, as for want of memory".into(),
        End::Signal(signal) => format!("ended by signal {signal}"),
        End::Limit => "given up at the time limit".into(),
    }
}
