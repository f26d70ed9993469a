//! `brinell check` and `brinell completions` as a user runs them: what they say of cases whose figures are
//! known, and with which status they end.

use assert_cmd::assert::Assert;
use assert_cmd::cargo::cargo_bin_cmd;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::msh::write::msh41;
use brinell::model::mesh::{Body, Mesh};
use serde_json::Value;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// What presses the upper block down.
const FORCE: &str = "[[rigid_plane]]\nsurface = \"upper_z_max\"\nforce = { z = \"-40 N\" }\n";
const CONTACT: &str =
    "[[contact]]\nupper = \"upper_z_min\"\nlower = \"lower_z_max\"\nfriction = 0\n";
/// What keeps the upper block from sliding.
const SIDES: &str = "[[support]]\nsurface = \"upper_x_min\"\nfixed = \"x\"\n[[support]]\nsurface = \
                     \"upper_y_min\"\nfixed = \"y\"\n";

/// Two blocks of steel, one on the other, the lower one fixed, with these parts besides.
fn scene(parts: &[&str]) -> String {
    let head = "units = \"mm-N-MPa\"\n[mesh]\nfile = \"blocks.msh\"\n[steel]\nyoungs_modulus = \
                200000\npoissons_ratio = 0.3\nelastic = true\n[[support]]\nsurface = \
                \"lower_z_min\"\nfixed = \"xyz\"\n";
    format!("{head}{}", parts.concat())
}

/// The lower block, 2 mm x 2 mm x 1 mm, and the upper one `gap` above it.
fn blocks(gap: f64) -> Mesh {
    let block = |z: f64, cells: usize| {
        let side = || uniform(0.0, 2.0, cells);
        Block::new("block", side(), side(), uniform(z, z + 1.0, 2))
            .build()
            .unwrap()
    };
    let lower = block(0.0, 3).prefixed("lower_");
    Mesh::join([lower, block(1.0 + gap, 4).prefixed("upper_")]).unwrap()
}

fn folder(text: &str, mesh: &Mesh) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), text).unwrap();
    std::fs::write(folder.path().join("blocks.msh"), msh41(mesh)).unwrap();
    folder
}

fn brinell(folder: &Path, line: &str) -> Assert {
    let mut command = cargo_bin_cmd!("brinell");
    command
        .current_dir(folder)
        .args(line.split_whitespace())
        .assert()
}

/// What `check --json` says of a scene, ending with `status`.
#[track_caller]
fn checked(text: &str, mesh: &Mesh, status: i32) -> Value {
    let folder = folder(text, mesh);
    let run = brinell(folder.path(), "check scene.toml --json").code(status);
    serde_json::from_slice(&run.get_output().stdout).unwrap()
}

#[track_caller]
fn close(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap_or(f64::NAN);
    let off = (value - expected).abs();
    assert!(
        off <= tolerance * expected.abs(),
        "{value} is not {expected}"
    );
}

/// Is one of the sentences about all of `words`?
#[track_caller]
fn says(list: &Value, words: &[&str]) {
    let sentences = list.as_array().unwrap().iter().map(|s| s.as_str().unwrap());
    let all = |sentence: &str| words.iter().all(|word| sentence.contains(word));
    assert!(sentences.into_iter().any(all), "{words:?} in {list}");
}

#[test]
fn bodies_gaps_and_holds_are_told() {
    let check = checked(&scene(&[CONTACT, SIDES, FORCE]), &blocks(0.25), 0);
    assert_eq!(check["bodies"][0]["elements"], 18);
    assert_eq!(check["bodies"][1]["nodes"], 75);
    close(&check["bodies"][1]["volume"], 4.0, 1e-12);
    close(&check["bodies"][1]["min_scaled_jacobian"], 1.0, 1e-12);
    close(&check["bodies"][0]["max_aspect_ratio"], 4.0 / 3.0, 1e-12);
    says(&check["bodies"][0]["held_by"], &["lower_z_min", "x, y, z"]);
    says(&check["bodies"][1]["held_by"], &["upper_z_max", "drives z"]);
    says(
        &check["bodies"][1]["held_by"],
        &["upper_z_min-lower_z_max", "frictionless"],
    );
    close(&check["contacts"][0]["gap"], 0.25, 1e-12);
    assert!(check["contacts"][0]["gap_at_touch"].as_f64().unwrap().abs() < 1e-9);
    says(&check["needs"], &["upper_block", "-0.250"]);
    says(&check["left_out"], &["friction 0"]);
    assert_eq!(check["problems"].as_array().unwrap().len(), 0);
}

#[test]
fn what_nothing_holds_fails_where_the_load_drives_it() {
    let check = checked(&scene(&[SIDES, FORCE]), &blocks(0.0), 1);
    says(&check["problems"], &["upper_block", "move along z"]);
    // The same, but for sliding, which nothing asks for: it runs.
    let text = scene(&[CONTACT, FORCE]);
    let check = checked(&text, &blocks(0.0), 0);
    says(&check["warnings"], &["upper_block", "move along"]);
    let there = folder(&text, &blocks(0.0));
    brinell(there.path(), "run scene.toml").code(0);
    // Friction holds it.
    let rough = CONTACT.replace("friction = 0", "friction = 0.2");
    let check = checked(&scene(&[&rough, FORCE]), &blocks(0.0), 0);
    assert_eq!(
        check["warnings"].as_array().unwrap().len(),
        0,
        "{}",
        check["warnings"]
    );
}

#[test]
fn overlaps_and_shared_nodes_are_warned_of() {
    let driven = "[[rigid_plane]]\nsurface = \"upper_z_max\"\nfixed = \"xy\"\ndisplacement = { z = -0.001 }\n";
    let check = checked(&scene(&[CONTACT, driven]), &blocks(-0.01), 0);
    close(&check["contacts"][0]["gap"], -0.01, 1e-9);
    says(&check["warnings"], &["overlap", "0.0100 mm"]);
    let side = || uniform(0.0, 2.0, 2);
    let block = Block::new("block", side(), side(), side());
    let mut welded = block.build().unwrap();
    let body = |name: &str, elements| Body {
        name: name.into(),
        elements,
    };
    welded.bodies = vec![body("lower_block", 0..4), body("upper_block", 4..8)];
    for surface in &mut welded.surfaces {
        let part = if surface.name == "z_min" {
            "lower"
        } else {
            "upper"
        };
        surface.name = format!("{part}_{}", surface.name);
    }
    let check = checked(&scene(&[FORCE]), &welded, 0);
    says(
        &check["warnings"],
        &["lower_block", "upper_block", "share 9 nodes"],
    );
}

/// Problem H: Hertz for 8.125 kip/in is a = 0.03094 in and p0 = 167.17 ksi, and the mesh of level 2 has 8
/// elements across a.
#[test]
fn the_strip_of_problem_h_is_known_before_it_is_solved() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/problem-h.toml");
    let folder = tempfile::tempdir().unwrap();
    let run = brinell(folder.path(), &format!("check {} --json", case.display())).code(0);
    let check: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    let strip = &check["strips"][0];
    close(&strip["line_load"], 8.125, 1e-6);
    close(&strip["half_width"], 0.03094, 1e-3);
    close(&strip["peak_pressure"], 167.17, 1e-3);
    close(&strip["elements"], 8.0, 0.05);
    close(&strip["pressure_error"], 1.0 / 256.0, 0.1);
    // What a run says before it factors, and finds.
    let run = brinell(folder.path(), &format!("run {}", case.display())).code(0);
    let printed = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    let unknowns = &check["cost"]["unknowns"];
    let gigabytes = 1e-9 * check["cost"]["memory_bytes"].as_f64().unwrap();
    let line = format!("{unknowns} unknowns, about {gigabytes:.2} GB of memory");
    assert!(printed.contains(&line), "{line} is not in {printed}");
}

#[test]
fn a_shipped_bearing_is_ready_and_its_coarse_mesh_warned_of() {
    let case = "cases/section-2.6.2/initial-centre.toml";
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let run = brinell(root, &format!("check {case} --mesh h025 --json")).code(0);
    let check: Value = serde_json::from_slice(run.get_output().stdout.as_slice()).unwrap();
    // Of the upper half of a quarter.
    assert_eq!(check["cost"]["unknowns"], 12578);
    // The plates of a quarter: 4 in x 4 in x 1 in.
    let bodies = check["bodies"].as_array().unwrap();
    let plate = bodies.iter().find(|b| b["name"] == "upper_plate").unwrap();
    close(&plate["volume"], 16.0, 1e-9);
    let strips = check["strips"].as_array().unwrap();
    assert_eq!(strips.len(), 4);
    close(&strips[0]["half_width"], 0.03094, 1e-3);
    // On two slopes of 4 degrees half the load each.
    let slope: f64 = 4.0;
    close(
        &strips[1]["line_load"],
        8.125 / 2.0 / slope.to_radians().cos(),
        1e-9,
    );
    let coarse = brinell(root, &format!("check {case} --mesh report-like")).code(0);
    let text = String::from_utf8_lossy(&coarse.get_output().stdout).into_owned();
    assert!(
        text.contains("unresolved") && text.contains("ready to run"),
        "{text}"
    );
}

/// Crowned rollers touch at a facet first: the load closes what holds them.
#[test]
fn crowned_rollers_are_ready() {
    let text = r#"title = "crowned"
units = "mm-N-MPa"
[bearing]
load = "300 kN"
friction = 0.15
roller_diameter = 80
roller_wall = 20
roller_length = 200
roller_end = { crown = 0.05 }
offset = 20
slope = 4
plate_thickness = 25
[steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
elastic = true
[mesh]
preset = "h025"
scale = 4
"#;
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let run = brinell(folder.path(), "check case.toml --json").code(0);
    let check: Value = serde_json::from_slice(run.get_output().stdout.as_slice()).unwrap();
    assert_eq!(check["problems"].as_array().unwrap().len(), 0);
    says(
        &check["warnings"],
        &["at first touch", "closes under the load"],
    );
}

#[test]
fn bad_input_is_told_from_what_would_fail() {
    let folder = folder(
        &scene(&[CONTACT.replace("upper_z_min", "upper_top").as_str(), FORCE]),
        &blocks(0.0),
    );
    let run = brinell(folder.path(), "check scene.toml").code(2);
    assert!(String::from_utf8_lossy(&run.get_output().stderr).contains("upper_top"));
    brinell(folder.path(), "check none.toml").code(2);
}

#[test]
fn completions_know_commands_and_presets() {
    let folder = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish"] {
        let run = brinell(folder.path(), &format!("completions {shell}")).code(0);
        let script = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
        for word in ["check", "report-like", "no-elastic-peaks"] {
            assert!(script.contains(word), "`{word}` for {shell}");
        }
    }
    let run = brinell(folder.path(), "completions bash").code(0);
    let script = folder.path().join("brinell.bash");
    std::fs::write(&script, &run.get_output().stdout).unwrap();
    let asked = "source brinell.bash; COMP_WORDS=(brinell che); COMP_CWORD=1; _brinell brinell che brinell; \
                 echo ${COMPREPLY[@]}";
    let answer = Command::new("bash")
        .args(["-c", asked])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(String::from_utf8_lossy(&answer.stdout).trim(), "check");
}

/// The displaced bearing takes more than half a gigabyte; a limit like that of a shared machine leaves less.
#[test]
fn too_little_memory_is_told_before_and_refused_by_a_run() {
    let case = "cases/section-2.6.2/initial-offset-2.5.toml";
    let folder = tempfile::tempdir().unwrap();
    let under_limit = |line: &str| {
        let mut shell = Command::new("sh");
        shell
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env("RAYON_NUM_THREADS", "2")
            .args(["-c", &format!("ulimit -v 600000 && exec \"$0\" {line}")])
            .arg(env!("CARGO_BIN_EXE_brinell"));
        assert_cmd::Command::from_std(shell).assert()
    };
    let run = under_limit(&format!("check {case} --mesh h025 --json")).code(1);
    let check: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    let left = check["machine"]["memory_bytes"].as_f64().unwrap();
    assert!(left < 6.1e8, "{left}");
    let problem = check["problems"][0].as_str().unwrap();
    assert!(problem.contains("GB of memory are needed"), "{problem}");
    let out = folder.path().display();
    let run = under_limit(&format!("run {case} --mesh h025 --out {out}")).code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(said.contains("GB are left"), "{said}");
}
