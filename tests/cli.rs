//! The commands as a user runs them: exit status, messages and files.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Stdio};
use std::time::{Duration, Instant};

use assert_cmd::assert::{Assert, OutputAssertExt};
use assert_cmd::cargo::cargo_bin_cmd;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::msh::write::msh41;
use serde_json::Value;
use tempfile::TempDir;

/// Two blocks of 2 mm × 2 mm × 1 mm, one on the other, pressed together by 40 N: uniaxial stress.
const SCENE: &str = r#"title = "two blocks"
units = "mm-N-MPa"

[mesh]
file = "blocks.msh"

[steel]
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
elastic = true

[[contact]]
name = "upper-lower"
upper = "upper_z_min"
lower = "lower_z_max"
friction = 0

[[support]]
surface = "lower_z_min"
fixed = "z"

[[support]]
surface = "lower_x_min"
fixed = "x"

[[support]]
surface = "lower_y_min"
fixed = "y"

[[support]]
surface = "upper_x_min"
fixed = "x"

[[support]]
surface = "upper_y_min"
fixed = "y"

[[rigid_plane]]
surface = "upper_z_max"
force = { z = "-40 N" }
"#;

/// The lower block, and the upper one with its low corner at (`aside`, 0, 1 + `gap`) mm.
fn blocks(aside: f64, gap: f64) -> Mesh {
    let block = |x: f64, z: f64, cells: usize| {
        let side = |from: f64| uniform(from, from + 2.0, cells);
        let block = Block::new("block", side(x), side(0.0), uniform(z, z + 1.0, 2));
        block.build().unwrap()
    };
    let lower = block(0.0, 0.0, 3).prefixed("lower_");
    Mesh::join([lower, block(aside, 1.0 + gap, 4).prefixed("upper_")]).unwrap()
}

/// A folder with the scene `text` in `scene.toml` and `mesh` beside it.
fn folder(text: &str, mesh: &Mesh) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), text).unwrap();
    std::fs::write(folder.path().join("blocks.msh"), msh41(mesh)).unwrap();
    folder
}

fn shipped(case: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases/section-2.6.2")
        .join(case)
}

/// The case of problem H.
fn problem_h() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/problem-h.toml")
}

/// Asserts that standard output says all of `parts`.
#[track_caller]
fn prints(assert: &Assert, parts: &[&str]) {
    let printed = words(&assert.get_output().stdout);
    for part in parts {
        assert!(printed.contains(part), "`{part}` is not in: {printed}");
    }
}

/// Runs `brinell` with the words of `line` in `folder`.
fn brinell(folder: &Path, line: &str) -> Assert {
    cargo_bin_cmd!("brinell")
        .current_dir(folder)
        .args(line.split_whitespace())
        .assert()
}

/// The words of a stream, without the frames and line breaks of an error report.
fn words(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace(['│', '╭', '╰', '─', '·', '×'], " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Asserts that standard error says all of `parts`.
#[track_caller]
fn says(assert: &Assert, parts: &[&str]) {
    let text = words(&assert.get_output().stderr);
    for part in parts {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
}

fn summary(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

#[track_caller]
fn close(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap_or(f64::NAN);
    let error = (value / expected - 1.0).abs();
    assert!(error <= tolerance, "{value}, expected {expected}");
}

/// Asserts that `summary` has every key that is promised.
#[track_caller]
fn has_every_key(summary: &Value, bodies: &[&str], interfaces: &[&str]) {
    let has = |value: &Value, keys: &[&str]| {
        for key in keys {
            assert!(value.get(key).is_some(), "`{key}` is missing in {value:#}");
        }
    };
    has(
        summary,
        &[
            "case",
            "units",
            "brinell_version",
            "converged",
            "dofs",
            "elements",
            "iterations",
            "factorisations",
            "timing",
            "peak_memory_bytes",
            "applied_load",
            "descent",
            "bodies",
            "interfaces",
            "rollers",
            "checks",
            "comparison",
            "assumptions",
            "left_out",
            "warnings",
        ],
    );
    let timing = &summary["timing"];
    has(timing, &["mesh_s", "solve_s", "total_s", "phases"]);
    has(&timing["phases"], &["assemble", "factorise"]);
    has(
        &summary["checks"],
        &[
            "force_balance",
            "max_penetration_relative",
            "coulomb_violation",
            "stabilisation_share",
        ],
    );
    has(&summary["bodies"], bodies);
    for body in bodies {
        let body = &summary["bodies"][body];
        let keys = [
            "mises_max",
            "at",
            "elastic_mises_max",
            "peeq_max",
            "yielded_volume",
        ];
        has(body, &keys);
        let measures = ["centroid", "integration_point", "nodal"];
        has(&body["mises_max"], &measures);
        has(&body["at"], &measures);
    }
    has(&summary["interfaces"], interfaces);
    for interface in interfaces {
        let keys = [
            "force",
            "normal_force",
            "pressure_integral",
            "max_pressure",
            "max_penetration",
            "area",
            "status_counts",
            "q",
        ];
        has(&summary["interfaces"][interface], &keys);
    }
}

/// The files that a collection names, which must all be whole.
fn collected(folder: &Path, name: &str) -> Vec<String> {
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let after = |line: &str| Some(line.split_once("file=\"")?.1.split_once('"')?.0.to_string());
    let files: Vec<String> = text.lines().filter_map(after).collect();
    for file in &files {
        let content = std::fs::read_to_string(folder.join(file)).unwrap();
        assert!(content.trim_end().ends_with("</VTKFile>"), "{file}");
    }
    files
}

#[test]
fn a_missing_case_is_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let run = brinell(folder.path(), "run nowhere/case.toml").code(2);
    says(&run, &["brinell::case::read", "nowhere/case.toml"]);
}

#[test]
fn a_wrong_unit_is_marked_in_the_file() {
    let text = SCENE.replace("200 GPa", "200 mm");
    let folder = folder(&text, &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml").code(2);
    let parts = [
        "brinell::case::unit",
        "youngs_modulus",
        "200 mm",
        "scene.toml:8:",
    ];
    says(&run, &parts);
}

#[test]
fn a_misspelt_key_is_marked_and_mended() {
    let text = SCENE.replace("poissons_ratio", "poisons_ratio");
    let folder = folder(&text, &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml").code(2);
    let parts = [
        "brinell::case::unknown_key",
        "poisons_ratio",
        "scene.toml:9:",
        "poissons_ratio",
    ];
    says(&run, &parts);
}

#[test]
fn a_missing_mesh_file_is_named() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    std::fs::remove_file(folder.path().join("blocks.msh")).unwrap();
    let run = brinell(folder.path(), "run scene.toml").code(2);
    says(&run, &["blocks.msh"]);
    assert!(!folder.path().join("results/scene/summary.json").exists());
}

#[test]
fn a_surface_that_the_mesh_lacks_is_named() {
    let text = SCENE.replace("\"upper_z_max\"", "\"upper_top\"");
    let folder = folder(&text, &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml").code(2);
    says(&run, &["upper_top", "scene.toml:"]);
}

#[test]
fn an_unknown_preset_is_refused_with_the_known_ones() {
    let folder = tempfile::tempdir().unwrap();
    let case = shipped("initial-centre.toml");
    let line = format!("run {} --mesh nonsense", case.display());
    let run = brinell(folder.path(), &line).code(2);
    says(&run, &["nonsense", "report-like", "h025", "auto"]);
}

#[test]
fn a_wrong_command_line_is_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    for line in ["", "walk", "run", "run a.toml --threads 0", "hertz"] {
        brinell(folder.path(), line).code(2);
    }
}

#[test]
fn the_handbook_prints_hertz() {
    let folder = tempfile::tempdir().unwrap();
    let line = "hertz --units in-kip-ksi --diameter 3 --wall 0.75 --length 8 --load 65 --yield 100 --friction 0.15";
    let run = brinell(folder.path(), line).code(0);
    let text = words(&run.get_output().stdout);
    let parts = [
        "peak pressure p0 167.17 ksi",
        "roller 93.202 ksi",
        "AASHTO LRFD 8.136 167.3 8.125 99.9 % indicative: within",
    ];
    for part in parts {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
    let thick = line.replace("--wall 0.75", "--wall 2");
    let run = brinell(folder.path(), &thick).code(2);
    says(&run, &["wall of the roller is 2, but it must be"]);
    let bare = line.replace("--units in-kip-ksi ", "");
    let run = brinell(folder.path(), &bare).code(2);
    says(
        &run,
        &[
            "brinell::hertz::no_unit",
            "--diameter 3 has no unit",
            "--units",
        ],
    );
}

#[test]
fn a_scene_runs_from_file_to_files() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let out = folder.path().join("out");
    let run = brinell(folder.path(), "run scene.toml --out out --threads 1").code(0);
    let text = words(&run.get_output().stdout);
    // The digest says what came of it, and no table.
    for said in [
        "two blocks: converged",
        "VERDICT Solved.",
        "load 40.00 N",
        "p max 10",
    ] {
        assert!(text.contains(said), "`{said}` is not in: {text}");
    }
    assert!(!text.contains("Largest Mises stress"), "{text}");
    let summary = summary(&out.join("summary.json"));
    let bodies = ["lower_block", "upper_block"];
    has_every_key(&summary, &bodies, &["upper-lower"]);
    assert_eq!(summary["converged"], true);
    for warning in summary["warnings"].as_array().unwrap() {
        let warning = warning.as_str().unwrap();
        assert!(!warning.contains("upper-lower"), "{warning}");
    }
    assert_eq!(summary["units"]["stress"], "MPa");
    close(&summary["applied_load"], 40.0, 1e-9);
    // σ h / E over both blocks.
    close(&summary["descent"], 10.0 * 2.0 / 200e3, 1e-7);
    let interface = &summary["interfaces"]["upper-lower"];
    close(&interface["normal_force"], 40.0, 1e-7);
    close(&interface["pressure_integral"], 40.0, 1e-7);
    close(&interface["max_pressure"], 10.0, 1e-7);
    close(&interface["area"], 4.0, 1e-9);
    for body in bodies {
        let mises = &summary["bodies"][body]["mises_max"];
        for measure in ["centroid", "integration_point", "nodal"] {
            close(&mises[measure], 10.0, 1e-7);
        }
    }
    let files = collected(&out, "scene.pvd");
    assert!(files.iter().any(|f| f.contains("_contact_")), "{files:?}");
    assert!(files.len() >= 2, "{files:?}");
}

#[test]
fn a_gap_in_a_force_driven_scene_is_closed_first() {
    let folder = folder(SCENE, &blocks(0.0, 0.25));
    let run = brinell(folder.path(), "run scene.toml --out out").code(0);
    let text = words(&run.get_output().stdout);
    assert!(text.contains("upper_block moved by"), "{text}");
    let summary = summary(&folder.path().join("out/summary.json"));
    close(
        &summary["interfaces"]["upper-lower"]["normal_force"],
        40.0,
        1e-7,
    );
    close(&summary["descent"], 1e-4, 1e-6);
}

#[test]
fn a_contact_pair_that_never_touches_is_warned_of_by_name() {
    let idle = "[[contact]]\nname = \"idle\"\nupper = \"upper_x_max\"\nlower = \"lower_x_max\"\nfriction = 0\n";
    let folder = folder(&format!("{SCENE}\n{idle}"), &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml --out out --quiet").code(0);
    let text = words(&run.get_output().stdout);
    assert!(
        text.contains("idle: the surfaces do not touch, so this contact pair carries nothing"),
        "{text}"
    );
    let summary = summary(&folder.path().join("out/summary.json"));
    let warnings = summary["warnings"].as_array().unwrap();
    assert!(
        warnings
            .iter()
            .any(|w| w.as_str().unwrap().contains("idle")),
        "{warnings:?}"
    );
}

#[test]
fn a_body_that_nothing_can_hold_is_named() {
    let folder = folder(SCENE, &blocks(40.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml --out out");
    let code = run.get_output().status.code();
    assert!(matches!(code, Some(2 | 3)), "{code:?}");
    says(&run, &["upper_block", "along z"]);
    assert!(!folder.path().join("out/summary.json").exists());
}

/// A limit on the size of files stands for a disk that is full: the system refuses to write on.
#[test]
fn a_full_disk_is_named_and_leaves_nothing_half_written() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let limited = "trap '' XFSZ; ulimit -f 1; exec \"$0\" run scene.toml --out out";
    let run = std::process::Command::new("bash")
        .args(["-c", limited, env!("CARGO_BIN_EXE_brinell")])
        .current_dir(folder.path())
        .assert()
        .code(2);
    says(&run, &["cannot write out/scene", "File too large"]);
    let out = folder.path().join("out");
    let left = std::fs::read_dir(&out).unwrap().flatten();
    for entry in left {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert!(!name.ends_with(".vtu") && !name.ends_with(".tmp"), "{name}");
    }
    brinell(folder.path(), "run scene.toml --out out --resume").code(0);
    assert!(!collected(&out, "scene.pvd").is_empty());
}

#[test]
fn the_page_of_a_run_is_left_out_where_it_is_not_wanted() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    brinell(folder.path(), "run scene.toml --out out --no-report").code(0);
    assert!(folder.path().join("out/summary.json").exists());
    assert!(!folder.path().join("out/report.html").exists());
}

#[test]
fn a_load_beyond_the_plastic_limit_does_not_converge() {
    let text = SCENE.replace("elastic = true", "yield_stress = \"5 MPa\"");
    let folder = folder(&text, &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml --out out").code(3);
    says(&run, &["brinell::solve::"]);
    // What was accepted before is on disk.
    assert!(!collected(&folder.path().join("out"), "scene.pvd").is_empty());
}

#[test]
fn a_step_that_does_not_converge_says_how_far_it_came() {
    // What a penalty leaves of contact is more than that.
    let controls = "[controls]\npenetration = 1e-30\nsmallest_increment = 0.1\n";
    let folder = folder(&format!("{SCENE}\n{controls}"), &blocks(0.0, 0.0));
    let run = brinell(folder.path(), "run scene.toml --out out").code(3);
    let parts = [
        "brinell::solve::not_converged",
        "step `load` did not converge",
        "of its load",
    ];
    says(&run, &parts);
    assert!(!folder.path().join("out/summary.json").exists());
}

const BODIES: [&str; 5] = [
    "upper_plate",
    "upper_roller",
    "intermediate_plate",
    "lower_roller",
    "lower_plate",
];

const INTERFACES: [&str; 4] = [
    "upper_plate-upper_roller",
    "upper_roller-intermediate_plate",
    "intermediate_plate-lower_roller",
    "lower_roller-lower_plate",
];

#[test]
fn the_main_case_runs_from_any_folder_on_its_shipped_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let case = shipped("initial-centre.toml");
    let line = format!("run {} --mesh report-like --all-tables", case.display());
    let run = cargo_bin_cmd!("brinell")
        .current_dir(folder.path())
        .args(line.split_whitespace())
        // A mesh of its own would need gmsh.
        .env("BRINELL_GMSH", "/nonexistent/gmsh")
        .assert()
        .code(0);
    let text = words(&run.get_output().stdout);
    assert!(text.contains("Largest Mises stress, ksi"), "{text}");
    let out = folder.path().join("results/initial-centre");
    let summary = summary(&out.join("summary.json"));
    has_every_key(&summary, &BODIES, &INTERFACES);
    assert_eq!(summary["converged"], true);
    close(&summary["applied_load"], 65.0, 1e-9);
    // What a checker recomputes, here by Hertz's formula with E = 29500 ksi, ν = 0.3 and R = 1.5 in.
    let by_hand = |what: &str| {
        let checks = summary["hand_checks"].as_array().unwrap().iter();
        let mut here = checks.filter(|c| c["where"] == "upper_plate-upper_roller");
        here.find(|c| c["what"] == what).unwrap()["by_hand"].clone()
    };
    let lines = &summary["interfaces"]["upper_plate-upper_roller"]["lines"];
    let q = lines[0]["peak"].as_f64().unwrap();
    let pressure = (q * 29500.0 / (2.0 * std::f64::consts::PI * 0.91 * 1.5)).sqrt();
    close(&by_hand("force along the load, kip"), 65.0, 1e-12);
    close(&by_hand("even line load, kip/in"), 8.125, 1e-12);
    close(&by_hand("peak pressure, ksi"), pressure, 1e-9);
    close(
        &by_hand("half-width, in"),
        2.0 * q / (std::f64::consts::PI * pressure),
        1e-9,
    );
    for interface in INTERFACES {
        let interface = &summary["interfaces"][interface];
        close(&interface["normal_force"], 65.0, 1e-6);
    }
    for roller in ["upper_roller", "lower_roller"] {
        let roller = &summary["rollers"][roller];
        assert!(roller.get("bore_mises").is_some(), "{roller}");
        assert!(roller["bore_mises_nodal"].is_f64(), "{roller}");
    }
    let row = &summary["comparison"][0];
    for key in [
        "what",
        "where",
        "report",
        "report_like",
        "value",
        "error",
        "hertz",
    ] {
        assert!(row.get(key).is_some(), "`{key}` is missing in {row}");
    }
    assert!(!collected(&out, "initial-centre.pvd").is_empty());
    assert!(summary["sizing"]["lines"][0]["hertz_pressure"].is_f64());
    assert!(summary["sizing"]["rule"]["exact"]["required_diameter_times_length"].is_f64());
    assert!(text.contains("Sizing rules (2-49) to (2-51)"), "{text}");
    let rules = &summary["rules"]["rules"];
    assert_eq!(rules[0]["name"], "(2-49)");
    close(&rules[0]["even"]["line_load"], 65.0 / 8.0, 1e-6);
    assert!(rules[0]["largest"]["utilisation"].is_f64(), "{rules}");
    assert_eq!(summary["rules"]["steel"].as_array().unwrap().len(), 5);
    for part in [
        "Design rules",
        "elastic shakedown 15.51 230.9",
        "under this load nothing yields",
    ] {
        assert!(text.contains(part), "{part} is not in {text}");
    }
    let data = std::fs::read_to_string(out.join("line-load.csv")).unwrap();
    assert!(data.starts_with("interface,axis,line across at [in],along [in],line load [kip/in]"));
    assert!(INTERFACES.iter().all(|name| data.contains(name)));
    let picture = std::fs::read_to_string(out.join("line-load.svg")).unwrap();
    assert!(INTERFACES.iter().all(|name| picture.contains(name)));
}

#[test]
fn a_case_finds_its_shipped_mesh_from_its_own_folder() {
    let out = tempfile::tempdir().unwrap();
    let line = "run initial-centre.toml --mesh report-like --elastic --quiet --out";
    let run = cargo_bin_cmd!("brinell")
        .current_dir(shipped(""))
        .args(line.split_whitespace())
        .arg(out.path())
        .env("BRINELL_GMSH", "/nonexistent/gmsh")
        .assert();
    run.code(0);
}

#[test]
fn a_load_in_stages_prints_its_slopes() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(shipped("initial-centre.toml")).unwrap();
    let text = text.replace("friction =", "stages = [\"26 kip\"]\nfriction =");
    // Nothing can yield, whatever is said of yielding.
    let text = text.replace("yield_stress =", "elastic = true #");
    let text = text.replace("hardening =", "#");
    std::fs::write(folder.path().join("staged.toml"), text).unwrap();
    let run = brinell(
        folder.path(),
        "run staged.toml --mesh report-like --all-tables",
    )
    .code(0);
    let table = words(&run.get_output().stdout);
    assert!(table.contains("slope kip/in stage 1 26.00"), "{table}");
    let summary = summary(&folder.path().join("results/staged/summary.json"));
    assert_eq!(summary["step"], "load");
    let line = &summary["load_line"];
    close(&line[0]["load"], 26.0, 1e-9);
    close(&line[1]["load"], 65.0, 1e-9);
    assert_eq!(line[1]["descent"], summary["descent"]);
    assert!(line[0]["descent"].as_f64() < line[1]["descent"].as_f64());
    // On this mesh nodes are farther apart than the strips are wide.
    let claims = summary["certificate"].as_array().unwrap();
    let pressure = claims
        .iter()
        .find(|c| c["what"] == "peak_pressure")
        .unwrap();
    assert_eq!(pressure["resolved"], false);
    assert_eq!(
        (&pressure["error"], &pressure["relative_error"]),
        (&Value::Null, &Value::Null)
    );
    let mut warnings = summary["warnings"].as_array().unwrap().iter();
    let named = |w: &Value| w.as_str().unwrap().starts_with("not resolved by this mesh");
    assert_eq!(warnings.by_ref().filter(|w| named(w)).count(), 1);
    let page = folder.path().join("results/staged/report.html");
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("Not resolved by this mesh"));
}

/// A run of the main case on a mesh of middling size, to be stopped, and its output.
struct Running {
    child: Child,
    output: BufReader<ChildStdout>,
}

impl Running {
    fn start(out: &Path) -> Self {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_brinell"))
            .arg("run")
            .arg(shipped("initial-centre.toml"))
            .args(["--mesh", "h025"])
            .arg("--out")
            .arg(out)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        Self { child, output }
    }

    /// Reads on until a line satisfies `wanted`.
    fn until(&mut self, wanted: impl Fn(&str) -> bool) {
        let mut line = String::new();
        while !wanted(&line) {
            line.clear();
            let read = self.output.read_line(&mut line).unwrap();
            assert!(read > 0, "the run ended too early");
        }
    }

    /// Presses Ctrl-C and returns the exit status.
    fn interrupt(self) -> Option<i32> {
        self.signal("-INT")
    }

    /// Sends a signal and returns the exit status.
    fn signal(mut self, signal: &str) -> Option<i32> {
        let id = self.child.id().to_string();
        let kill = std::process::Command::new("kill")
            .args([signal, &id])
            .status();
        assert!(kill.unwrap().success());
        let start = Instant::now();
        let mut rest = String::new();
        while std::io::Read::read_to_string(&mut self.output, &mut rest).is_ok_and(|n| n > 0) {}
        let status = self.child.wait().unwrap();
        assert!(start.elapsed() < Duration::from_secs(60));
        status.code()
    }
}

#[test]
fn an_interrupted_run_leaves_whole_files() {
    let folder = tempfile::tempdir().unwrap();
    let mut run = Running::start(folder.path());
    // An increment ends before the next one begins to iterate: its column `it` is 1 again.
    let first = |line: &str| line.split_whitespace().nth(1) == Some("1");
    let pvd = folder.path().join("initial-centre.pvd");
    run.until(first);
    run.until(|line| first(line) && pvd.exists());
    assert_eq!(run.interrupt(), Some(130));
    let files = collected(folder.path(), "initial-centre.pvd");
    assert!(!files.is_empty());
    let summary = summary(&folder.path().join("summary.json"));
    assert_eq!(summary["converged"], false);
    has_every_key(&summary, &BODIES, &INTERFACES);
    for entry in std::fs::read_dir(folder.path()).unwrap() {
        let name = entry.unwrap().file_name();
        assert!(!name.to_string_lossy().ends_with(".tmp"), "{name:?}");
    }
}

/// A queue that takes a job's time away sends SIGTERM.
#[test]
fn a_run_that_is_terminated_ends_as_an_interrupted_one() {
    let folder = tempfile::tempdir().unwrap();
    let mut run = Running::start(folder.path());
    let pvd = folder.path().join("initial-centre.pvd");
    run.until(|line| line.split_whitespace().nth(1) == Some("1") && pvd.exists());
    assert_eq!(run.signal("-TERM"), Some(130));
    let summary = summary(&folder.path().join("summary.json"));
    assert_eq!(summary["converged"], false);
}

fn names(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).unwrap();
    let name = |file: std::io::Result<std::fs::DirEntry>| file.unwrap().file_name();
    let mut names: Vec<String> = files.map(|f| name(f).into_string().unwrap()).collect();
    names.sort();
    names
}

/// What an earlier run left stays until there is something of this one; then it goes altogether.
#[test]
fn results_of_an_earlier_case_stay_until_there_are_new_ones() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let at = |name: &str| folder.path().join(name);
    brinell(folder.path(), "run scene.toml --out out").success();
    let before = names(&at("out"));
    assert!(before.iter().any(|name| name == "scene-views.py"));
    let kept = |name: &str| std::fs::read(at("out").join(name)).unwrap();
    let summary = kept("summary.json");

    // A mesh that is none, and a scene that nothing balances.
    std::fs::write(at("other.toml"), SCENE.replace("blocks.msh", "none.msh")).unwrap();
    std::fs::write(at("none.msh"), "no mesh").unwrap();
    brinell(folder.path(), "run other.toml --out out").code(2);
    std::fs::write(at("loose.toml"), SCENE).unwrap();
    let text = std::fs::read_to_string(at("loose.toml")).unwrap();
    let loose = format!("{text}\n[controls]\npenetration = 1e-30\nsmallest_increment = 0.1\n");
    std::fs::write(at("loose.toml"), loose).unwrap();
    brinell(folder.path(), "run loose.toml --out out").code(3);
    assert_eq!(names(&at("out")), before);
    assert_eq!(kept("summary.json"), summary);

    std::fs::write(at("other.toml"), SCENE).unwrap();
    std::fs::write(at("out").join("notes.txt"), "mine").unwrap();
    brinell(folder.path(), "run other.toml --out out").success();
    let after = names(&at("out"));
    assert!(
        after.iter().all(|name| !name.starts_with("scene")),
        "{after:?}"
    );
    assert!(after.contains(&"other.pvd".to_owned()) && after.contains(&"notes.txt".to_owned()));
}

/// A checkpoint with a bit turned over, or cut short, is refused: never believed, and nothing is lost by it.
#[test]
fn a_checkpoint_that_is_damaged_is_refused() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    brinell(folder.path(), "run scene.toml --out out").success();
    let path = folder.path().join("out/checkpoint.bin");
    let sound = std::fs::read(&path).unwrap();
    let summary = std::fs::read(folder.path().join("out/summary.json")).unwrap();
    // Spread over the file, and in all of its head.
    let bits = 8 * sound.len();
    let flips = (0..40)
        .map(|k| k * 13)
        .chain((1..40).map(|k| k * bits / 40));
    let flipped = flips.map(|bit| {
        let mut bytes = sound.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        bytes
    });
    let cut = (0..20).map(|k| sound[..k * sound.len() / 20].to_vec());
    for bytes in flipped.chain(cut) {
        std::fs::write(&path, &bytes).unwrap();
        let run = brinell(folder.path(), "run scene.toml --out out --resume").code(2);
        says(&run, &["checkpoint"]);
        let kept = std::fs::read(folder.path().join("out/summary.json")).unwrap();
        assert_eq!(kept, summary);
    }
}

/// Where a link waits under the name of a file of the run, the file it points to is left alone.
#[cfg(unix)]
#[test]
fn nothing_is_written_through_a_link() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let mine = folder.path().join("mine.txt");
    std::fs::write(&mine, "mine").unwrap();
    let out = folder.path().join("out");
    std::fs::create_dir(&out).unwrap();
    for name in [
        ".lock",
        "summary.json",
        "summary.json.tmp",
        "scene.pvd",
        "scene_0001.vtu.tmp",
        "report.html",
    ] {
        std::os::unix::fs::symlink(&mine, out.join(name)).unwrap();
    }
    brinell(folder.path(), "run scene.toml --out out").success();
    assert_eq!(std::fs::read_to_string(&mine).unwrap(), "mine");
    assert!(!out.join("summary.json").is_symlink());
}

#[cfg(target_os = "linux")]
#[test]
fn a_standard_output_that_is_full_is_told() {
    let full = std::fs::File::options()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args("hertz --units in-kip-ksi --diameter 3 --length 8 --load 130 --yield 100".split(' '))
        .stdout(full)
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(2), "{text}");
    assert!(text.contains("cannot write standard output"), "{text}");
}

#[test]
fn a_run_interrupted_at_once_leaves_no_answer() {
    let folder = tempfile::tempdir().unwrap();
    let mut run = Running::start(folder.path());
    run.until(|line| line.starts_with("load:"));
    assert_eq!(run.interrupt(), Some(130));
    assert!(!folder.path().join("summary.json").exists());
}

#[test]
fn a_series_of_split_meshes_names_its_reference_and_leaves_json_and_a_plot() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let run = brinell(
        folder.path(),
        "converge scene.toml --levels 3 --element bbar,enhanced --out out",
    )
    .code(0);
    let text = words(&run.get_output().stdout);
    for part in [
        "split: every hexahedron into eight",
        "reference:",
        "memory MB",
        "CPU s",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    let study = summary(&folder.path().join("out/converge.json"));
    let levels = study["levels"].as_array().unwrap();
    assert_eq!(levels.len(), 6);
    for key in ["dofs", "wall_s", "cpu_s", "peak_memory_bytes", "values"] {
        assert!(levels[5].get(key).is_some(), "`{key}` in {}", levels[5]);
    }
    for i in 0..2 {
        let count = |level: usize| levels[2 * level + i]["elements"].as_u64().unwrap();
        assert_eq!([count(1), count(2)], [8 * count(0), 64 * count(0)]);
    }
    // Uniaxial stress is exact on every mesh.
    for curve in study["curves"].as_array().unwrap() {
        for error in curve["errors"].as_array().unwrap() {
            assert!(error.as_f64().is_none_or(|e| e.abs() < 1e-6), "{curve}");
        }
    }
    let plot = std::fs::read_to_string(folder.path().join("out/converge.svg")).unwrap();
    assert!(plot.starts_with("<svg") && plot.contains("</svg>"));
}

#[test]
fn a_series_of_mesh_files_is_taken_as_it_is_given() {
    let folder = folder(SCENE, &blocks(0.0, 0.0));
    let finer = blocks(0.0, 0.0).split().unwrap();
    std::fs::write(folder.path().join("finer.msh"), msh41(&finer)).unwrap();
    let line = "converge scene.toml --mesh blocks.msh --mesh finer.msh --out out";
    brinell(folder.path(), line).code(0);
    let study = summary(&folder.path().join("out/converge.json"));
    assert_eq!(study["levels"].as_array().unwrap().len(), 2);
    let run = brinell(folder.path(), "converge scene.toml --mesh blocks.msh").code(2);
    says(&run, &["two meshes or more"]);
    let run = brinell(folder.path(), "converge scene.toml --write").code(2);
    says(&run, &["problem-h"]);
}

#[test]
fn problem_h_is_built_in() {
    let folder = tempfile::tempdir().unwrap();
    let run = brinell(folder.path(), "converge problem-h --levels 3").code(0);
    let text = words(&run.get_output().stdout);
    assert!(
        text.contains("half-width, in, bbar: reference 0.0309420"),
        "{text}"
    );
    let study = summary(
        &folder
            .path()
            .join("results/problem-h-converge/converge.json"),
    );
    let curves = study["curves"].as_array().unwrap();
    let find = |quantity: &str| {
        let found = |c: &&Value| c["quantity"] == quantity && c["element"] == "enhanced";
        curves.iter().find(found).unwrap()
    };
    assert_eq!(
        find("potential energy")["reference"]["kind"],
        "extrapolated"
    );
    assert!(find("pressure L2")["order"].as_f64().unwrap() > 0.9);
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/problem-h.toml");
    let line = format!("run {} --quiet --out run", case.display());
    brinell(folder.path(), &line).code(0);
}

#[test]
fn a_bearing_takes_a_preset_and_no_mesh_files() {
    let folder = tempfile::tempdir().unwrap();
    let case = shipped("initial-centre.toml");
    for (arguments, words) in [
        ("--mesh a.msh --mesh b.msh", "template"),
        ("--mesh nonsense", "report-like"),
        ("--factor 1", "factor"),
    ] {
        let line = format!("converge {} {arguments}", case.display());
        let run = brinell(folder.path(), &line).code(2);
        says(&run, &[words]);
    }
}

#[test]
fn a_deck_is_named_after_its_case() {
    let folder = folder(SCENE, &blocks(0.0, 0.1));
    let out = brinell(folder.path(), "export scene.toml --format inp --out decks").code(0);
    let said = words(&out.get_output().stdout);
    assert!(
        said.contains("to close its gap") && said.contains("scene.inp"),
        "{said}"
    );
    let deck = std::fs::read_to_string(folder.path().join("decks/scene.inp")).unwrap();
    for line in [
        "** Units: mm, N, MPa.",
        "*CONTACT PAIR,INTERACTION=UPPER_LOWER,TYPE=SURFACE TO SURFACE",
    ] {
        assert!(deck.lines().any(|l| l == line), "`{line}` is missing");
    }
    // Pressed by pressure alone: the cylinder starts inside the block.
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/problem-h.toml");
    let line = format!(
        "export {} --format inp --out h --closing 0.001",
        case.display()
    );
    brinell(folder.path(), &line).code(0);
    let deck = std::fs::read_to_string(folder.path().join("h/problem-h.inp")).unwrap();
    let nodes = deck.lines().skip_while(|l| !l.starts_with("*NODE")).skip(1);
    let nodes = nodes.take_while(|l| !l.starts_with('*'));
    let height = |line: &str| line.split(',').nth(2).unwrap().parse::<f64>().unwrap();
    let cylinder = nodes.map(height).filter(|y| (-0.1..0.0).contains(y));
    let lowest = cylinder.filter(|y| (y + 0.001).abs() < 1e-5).count();
    assert!(lowest > 0, "the cylinder does not overlap by 0.001");
    let line = "export scene.toml --format inp --out decks --contact-stiffness 0";
    says(
        &brinell(folder.path(), line).code(2),
        &["contact stiffness"],
    );
    brinell(folder.path(), "export scene.toml --out decks").code(2);
}

/// A coarse mesh of a roller whose ends are rounded and whose face is crowned.
const ROUNDED: &str = r#"title = "rounded"
units = "mm-N-MPa"

[line_bearing]
load = "100 kN"
friction = 0.1
solid = true
roller_diameter = "100 mm"
roller_length = "100 mm"
roller_end = { radius = "24 mm", crown = "1 mm" }
plate_thickness = "40 mm"

[mesh]
preset = "h025"
scale = 3

[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
elastic = true
"#;

#[test]
fn the_quality_of_a_mesh_is_that_of_the_shape_that_is_solved() {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("case.toml"), ROUNDED).unwrap();
    let mesh = brinell(folder.path(), "mesh case.toml").success();
    let check = brinell(folder.path(), "check case.toml --json").success();
    let check: Value = serde_json::from_slice(&check.get_output().stdout).unwrap();
    let roller = &check["bodies"][0];
    assert_eq!(roller["name"], "roller");
    let jacobian = roller["min_scaled_jacobian"].as_f64().unwrap();
    prints(&mesh, &[&format!("scaled Jacobian >= {jacobian:.3},")]);
}

#[test]
fn a_mesh_takes_the_place_of_meshes_alone() {
    let folder = TempDir::new().unwrap();
    let case = folder.path().join("case.toml");
    std::fs::write(&case, ROUNDED).unwrap();
    let refused = brinell(folder.path(), "mesh case.toml --out case.toml").code(2);
    says(&refused, &["case.toml is there already, and is no mesh"]);
    assert_eq!(std::fs::read_to_string(&case).unwrap(), ROUNDED);
    for _ in 0..2 {
        brinell(folder.path(), "mesh case.toml --out part.msh").success();
    }
}

#[test]
fn a_target_is_met_by_finer_meshes() {
    let folder = TempDir::new().unwrap();
    let case = problem_h();
    let case = std::fs::read_to_string(case).unwrap();
    let case = case.replace("level = 2", "level = 1");
    std::fs::write(folder.path().join("case.toml"), case).unwrap();
    let run = brinell(
        folder.path(),
        "run case.toml --out out --quiet --target half-width=0.5%",
    );
    let run = run.success();
    prints(&run, &["half-width", "cylinder-block"]);
    let finest = (0..9)
        .rev()
        .map(|k| folder.path().join(format!("out/level-{k}/summary.json")))
        .find(|path| path.exists())
        .expect("a level");
    let claims = summary(&finest)["certificate"].clone();
    let claims = claims.as_array().unwrap();
    let half_width = claims.iter().find(|c| c["what"] == "half_width").unwrap();
    // Hertz, and 0.15 % for the finite bodies.
    close(&half_width["value"], 0.030942, 0.0065);
}

#[test]
fn a_target_of_all_certified_figures_asks_for_those_that_there_are() {
    let folder = TempDir::new().unwrap();
    let case = std::fs::read_to_string(problem_h()).unwrap();
    std::fs::write(folder.path().join("case.toml"), case).unwrap();
    let line = "run case.toml --out out --quiet --target 20%";
    let run = brinell(folder.path(), line).success();
    let figures = [
        "peak pressure",
        "Hertz",
        "line load",
        "peak Mises",
        "descent",
    ];
    prints(&run, &figures);
    prints(&run, &["Not asked for, as this answer has none: bore"]);
    // Of other scenes than bearings a second mesh has to agree.
    assert!(folder.path().join("out/level-1/summary.json").exists());
}

#[test]
fn where_steel_flows_a_target_says_which_mesh_elastic_figures_are_of() {
    let folder = TempDir::new().unwrap();
    let case =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let line = format!(
        "run {} --out out --quiet --target elastic-mises=8%",
        case.display()
    );
    let run = brinell(folder.path(), &line).success();
    prints(
        &run,
        &[
            "0, elastic",
            "elastic figures are of the elastic solution",
            "in level-0",
        ],
    );
    let of = |level: &str| summary(&folder.path().join(format!("out/{level}/summary.json")));
    let (twin, own) = (of("level-0"), of("level-1"));
    assert!(twin["elastic_twin"].is_null());
    assert_eq!(own["elastic_twin"]["folder"], "level-0");
    assert_eq!(own["elastic_twin"]["dofs"], twin["dofs"]);
    let claim = |of: &serde_json::Value, what: &str| {
        let claims = of["certificate"].as_array().unwrap().clone();
        let same = |c: &serde_json::Value| c["what"] == what && c["where"] == "lower_plate";
        claims.into_iter().find(same).unwrap()
    };
    let [of_twin, taken] = [
        claim(&twin, "mises_away"),
        claim(&own, "elastic_mises_away"),
    ];
    let mesh = |claim: &serde_json::Value| claim["causes"]["discretisation"].clone();
    assert_eq!(of_twin["value"], taken["value"]);
    assert_eq!(mesh(&of_twin), mesh(&taken));
    assert!(
        taken["note"]
            .as_str()
            .unwrap()
            .contains("a mesh of its own")
    );
}

#[test]
fn a_target_that_no_mesh_meets_is_said_to_be_missed() {
    let folder = TempDir::new().unwrap();
    let run = brinell(
        folder.path(),
        &format!(
            "run {} --out out --quiet --target plastic-strain=1%",
            problem_h().display()
        ),
    );
    prints(
        &run.code(1),
        &["FAILED", "the certificate has no plastic-strain"],
    );
}

#[test]
fn a_target_that_is_none_is_refused() {
    let folder = TempDir::new().unwrap();
    let case = problem_h();
    let run = brinell(
        folder.path(),
        &format!("run {} --target mass=2%", case.display()),
    );
    says(
        &run.code(2),
        &["mass=2%", "such as 3%", "plastic-strain, pressure"],
    );
}

#[test]
fn the_page_of_the_study_says_what_the_coarse_mesh_gives() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    let line = format!(
        "study section-2.6.2 --mesh report-like --check --out {}",
        out.display()
    );
    prints(
        &brinell(root, &line).success(),
        &["says what this run says"],
    );
}

#[test]
fn a_study_that_is_none_is_refused() {
    let folder = TempDir::new().unwrap();
    let run = brinell(folder.path(), "study section-9.9");
    says(&run.code(2), &["section-2.6.2"]);
}
