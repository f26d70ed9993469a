//! Runs on machines that have too little for them: refused in words before anything is wasted, never killed.

use brinell::product::job::MESH_FILE;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

fn shipped(case: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(case)
}

/// Standard error without frames and line breaks.
fn said(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).replace(['│', '╰', '─', '▶', '×'], " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A folder with the files of a kernel, as `BRINELL_SYSTEM_ROOT` names it.
fn kernel(files: &[(&str, &str)]) -> TempDir {
    let root = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = root.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    root
}

/// Runs `brinell` with the address space limited to so many kB.
#[cfg(target_os = "linux")]
fn within(limit: u32, threads: u32, case: &Path, arguments: &[&str]) -> Output {
    let folder = tempfile::tempdir().unwrap();
    Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", "ulimit -v $0 && exec \"$@\"", &limit.to_string()])
        .args([env!("CARGO_BIN_EXE_brinell"), "run"])
        .arg(case)
        .args(["--out", "out", "--threads", &threads.to_string()])
        .args(arguments)
        .output()
        .unwrap()
}

/// Was it solved, or refused with what is missing?
#[cfg(target_os = "linux")]
#[track_caller]
fn ended_well(output: &Output, limit: u32, threads: u32) -> bool {
    let words = said(output);
    let status = output.status.code();
    let refused = words.contains("GB of memory") && words.contains("GB are left");
    assert!(
        status == Some(0) || status == Some(2) && refused,
        "{limit} kB, {threads} threads: {} {words}",
        output.status
    );
    status == Some(0)
}

#[cfg(target_os = "linux")]
#[test]
fn a_limit_of_the_address_space_never_kills_a_run() {
    const LIMITS: [u32; 10] = [
        200_000, 300_000, 450_000, 700_000, 1_000_000, 1_500_000, 2_300_000, 3_500_000, 5_300_000,
        8_000_000,
    ];
    let blocks = shipped("extreme/stack.toml");
    for threads in [1, 2, 4, 8] {
        let run = |limit| ended_well(&within(limit, threads, &blocks, &[]), limit, threads);
        let solved = LIMITS.map(run);
        assert!(solved[9], "{threads} threads: {solved:?}");
    }
    // A bearing, whose factors all threads work on.
    let bearing = shipped("section-2.6.2/initial-centre.toml");
    for (limit, threads) in [(200_000, 8), (2_300_000, 2), (8_000_000, 8)] {
        let output = within(limit, threads, &bearing, &["--mesh", "report-like"]);
        ended_well(&output, limit, threads);
    }
}

/// A displaced bearing whose half takes 0.4 GB, as the machine in `root` sees it: the bytes that `check` finds there, and
/// whether they are enough.
#[track_caller]
fn checked(root: &TempDir) -> (f64, bool) {
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .env("BRINELL_SYSTEM_ROOT", root.path())
        .arg("check")
        .arg(shipped("section-2.6.2/initial-offset-2.5.toml"))
        .arg("--json")
        .output()
        .unwrap();
    let check: Value = serde_json::from_slice(&output.stdout).unwrap();
    let needed = check["cost"]["memory_bytes"].as_f64().unwrap();
    assert!((3.2e8..1.5e9).contains(&needed), "{needed}");
    let problems = check["problems"].to_string();
    let enough = !problems.contains("GB of memory are needed");
    assert_eq!(output.status.success(), enough, "{problems}");
    (check["machine"]["memory_bytes"].as_f64().unwrap(), enough)
}

#[track_caller]
fn refused_by_a_run(root: &TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .current_dir(folder.path())
        .env("BRINELL_SYSTEM_ROOT", root.path())
        .arg("run")
        .arg(shipped("section-2.6.2/initial-offset-2.5.toml"))
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let words = said(&output);
    assert!(words.contains("and 0.29 GB are left"), "{words}");
}

/// The group of the job has 300 MB, that of its step no limit of its own. 290 MB are taken, all but 10 MB of them by
/// the page cache.
#[test]
fn a_case_beyond_its_control_group_is_refused() {
    const MEMINFO: (&str, &str) = ("proc/meminfo", "MemAvailable: 8000000 kB\n");
    let group = "sys/fs/cgroup/job";
    let file = |name: &str| format!("{group}/{name}");
    let second = |limit: &str| {
        kernel(&[
            MEMINFO,
            ("proc/self/cgroup", "0::/job/step\n"),
            (&file("memory.max"), limit),
            (&file("memory.current"), "290000000\n"),
            (
                &file("memory.stat"),
                "anon 10000000\nactive_file 100000000\ninactive_file 180000000\n",
            ),
            (&file("step/memory.max"), "max\n"),
            (&file("step/memory.current"), "290000000\n"),
        ])
    };
    let root = second("300000000\n");
    assert_eq!(checked(&root), (2.9e8, false));
    refused_by_a_run(&root);
    assert_eq!(checked(&second("3000000000\n")), (2.99e9, true));

    let group = "sys/fs/cgroup/memory/job";
    let file = |name: &str| format!("{group}/{name}");
    let root = kernel(&[
        MEMINFO,
        ("proc/self/cgroup", "5:cpu:/\n3:memory:/job/step\n0::/\n"),
        (&file("memory.limit_in_bytes"), "300000000\n"),
        (&file("memory.usage_in_bytes"), "290000000\n"),
        (
            &file("memory.stat"),
            "inactive_file 5\ntotal_active_file 100000000\ntotal_inactive_file 180000000\n",
        ),
        (&file("step/memory.limit_in_bytes"), "9223372036854771712\n"),
    ]);
    assert_eq!(checked(&root), (2.9e8, false));
    refused_by_a_run(&root);
}

/// Level 1 of problem H takes 23 MB, level 2 takes 129: the answer on level 1 stands, and what an earlier run left beyond
/// it and beside the levels goes.
#[test]
fn a_target_whose_next_mesh_is_beyond_the_memory_keeps_its_last_answer() {
    let root = kernel(&[
        ("proc/meminfo", "MemAvailable: 60000 kB\n"),
        ("out/report.html", "of an earlier run"),
        ("out/level-2/summary.json", "of an earlier run"),
    ]);
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .current_dir(root.path())
        .env("BRINELL_SYSTEM_ROOT", root.path())
        .arg("run")
        .arg(shipped("problem-h.toml"))
        .args(["--out", "out", "--quiet", "--target", "0.1%"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let last = Path::new("out/level-1");
    let place = format!("written to {}", last.display());
    for part in ["there is no finer one", "GB are left", place.as_str()] {
        assert!(told.contains(part), "{part}: {told}");
    }
    assert!(root.path().join(last).join("summary.json").exists());
    for gone in ["out/report.html", "out/level-2/summary.json"] {
        assert!(!root.path().join(gone).exists(), "{gone}");
    }
}

/// What becomes of the centred bearing with `from` changed to `to` on a machine with 4 GB, and whether gmsh was called.
#[cfg(unix)]
fn meshed(changes: &[(&str, &str)]) -> (Output, bool) {
    use std::os::unix::fs::PermissionsExt;
    let case = std::fs::read_to_string(shipped("section-2.6.2/initial-centre.toml")).unwrap();
    let text = changes.iter().fold(case, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let root = kernel(&[("proc/meminfo", "MemAvailable: 4000000 kB\n")]);
    let place = |name: &str| root.path().join(name);
    std::fs::write(place("case.toml"), text).unwrap();
    std::fs::write(place("gmsh"), "#!/bin/sh\n: >called\nexit 1\n").unwrap();
    std::fs::set_permissions(place("gmsh"), PermissionsExt::from_mode(0o755)).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .current_dir(root.path())
        .env("BRINELL_SYSTEM_ROOT", root.path())
        .env("BRINELL_GMSH", place("gmsh"))
        .args(["mesh", "case.toml", "--out", MESH_FILE])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    (output, place("called").exists())
}

#[cfg(unix)]
#[test]
fn a_mesh_beyond_the_memory_is_refused_before_gmsh_is_called() {
    let preset = "preset = \"auto\"";
    let h0125 = |more: &str| format!("preset = \"h0125\"\n{more}");
    let long = ("roller_length = \"8 in\"", "roller_length = \"1e9 in\"");
    for changes in [
        vec![(preset, h0125("scale = 0.1").as_str())],
        vec![(preset, h0125("growth = 1\ndepth_growth = 1").as_str())],
        vec![(preset, "preset = \"report-like\""), long],
    ] {
        let (output, called) = meshed(&changes);
        let words = said(&output);
        assert!(words.contains("the mesh would have about"), "{words}");
        let elements = words
            .split_whitespace()
            .skip_while(|w| *w != "about")
            .nth(1);
        let elements: f64 = elements.unwrap().parse().unwrap();
        // 5 kB each.
        assert!(elements > 4e9 / 5e3, "{words}");
        assert!(!called, "{words}");
    }
    // Elements that are too thin to be meant are wrong however many there are.
    let (output, called) = meshed(&[(preset, "preset = \"auto\"\nscale = 0.02")]);
    assert!(said(&output).contains("must be at least") && !called);
    // What is small is made.
    let (output, called) = meshed(&[(preset, "preset = \"auto\"\nscale = 2")]);
    assert!(said(&output).contains("gmsh failed") && called);
}
