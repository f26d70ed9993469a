//! Several steps: of which moment the figures are, and where dents are read.

use assert_cmd::cargo::cargo_bin_cmd;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::family::problem_h::{HALF_WIDTH, RADIUS, Sizes, full_twins};
use brinell::model::mesh::msh::write::msh41;
use serde_json::Value;

/// Two blocks of 2 mm × 2 mm × 1 mm, one on the other: uniaxial stress. 40 N make 10 MPa.
const BLOCKS: &str = r#"title = "two blocks"
units = "mm-N-MPa"
mesh.file = "mesh.msh"

[steel]
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
yield_stress = "8 MPa"
hardening_modulus = "1 GPa"

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

"#;

const FORCE: &str =
    "[[rigid_plane]]\nname = \"P\"\nsurface = \"upper_z_max\"\nforce = { z = -40.0 }\n";
const TRAVEL: &str =
    "[[rigid_plane]]\nname = \"P\"\nsurface = \"upper_z_max\"\ndisplacement = { z = -0.002 }\n";

fn blocks() -> Mesh {
    let block = |z: f64, cells: usize| {
        let side = || uniform(0.0, 2.0, cells);
        let block = Block::new("block", side(), side(), uniform(z, z + 1.0, 2));
        block.build().unwrap()
    };
    Mesh::join([
        block(0.0, 2).prefixed("lower_"),
        block(1.0, 3).prefixed("upper_"),
    ])
    .unwrap()
}

/// The summary and the printed table of the scene `text` on `mesh`.
#[track_caller]
fn run(text: &str, mesh: &Mesh) -> (Value, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), text).unwrap();
    std::fs::write(folder.path().join("mesh.msh"), msh41(mesh)).unwrap();
    let run = cargo_bin_cmd!("brinell")
        .current_dir(folder.path())
        .args([
            "run",
            "scene.toml",
            "--out",
            "out",
            "--threads",
            "1",
            "--all-tables",
        ])
        .assert()
        .code(0);
    let json = std::fs::read_to_string(folder.path().join("out/summary.json")).unwrap();
    let printed = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    let summary: Value = serde_json::from_str(&json).unwrap();
    // The views are of the moment that the figures are of.
    let views = std::fs::read_to_string(folder.path().join("out/scene-views.py")).unwrap();
    let mut steps = summary["steps"].as_array().unwrap().iter();
    let reported = steps.position(|step| step["reported"] == true).unwrap();
    let full_load = format!("FULL_LOAD = {}.0\n", reported + 1);
    assert!(views.contains(&full_load), "not {full_load}");
    (summary, printed)
}

/// The two blocks, loaded by `load`, at these factors at the ends of steps 0, 1, ...
#[track_caller]
fn cycled(load: &str, factors: &[f64]) -> Value {
    let mut text = format!("{BLOCKS}{load}");
    for (i, factor) in factors.iter().enumerate() {
        text += &format!("[[step]]\nname = \"{i}\"\nfactor = {factor}\n");
    }
    let (summary, _) = run(&text, &blocks());
    assert_eq!(summary["steps"].as_array().unwrap().len(), factors.len());
    summary
}

#[track_caller]
fn close(value: &Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    let off = (value - expected).abs();
    assert!(
        off <= tolerance * expected.abs().max(1e-300),
        "{value}, not {expected}"
    );
}

#[test]
fn forces_that_are_taken_off_leave_the_figures_of_the_load() {
    for factors in [&[1.0, 1e-3][..], &[0.4, 1.0, 0.5, 1e-3]] {
        let summary = cycled(FORCE, factors);
        let loaded = factors.iter().position(|f| *f == 1.0).unwrap();
        assert_eq!(summary["step"], loaded.to_string());
        assert_eq!(summary["steps"][loaded]["reported"], true);
        close(&summary["applied_load"], 40.0, 1e-12);
        close(&summary["unloaded"]["applied_load"], 0.04, 1e-12);
        // (10 - 8) MPa of hardening.
        close(&summary["unloaded"]["peeq_max"]["upper_block"], 2e-3, 1e-6);
        let dents = summary["unloaded"]["dents"].as_object().unwrap();
        assert_eq!(dents.len(), 2);
    }
}

/// Between supports that move there is no contact and no plane whose force would say that nothing is left.
#[test]
fn supports_that_go_back_end_where_they_are() {
    let side = || uniform(0.0, 2.0, 1);
    let bar = Block::new("bar", side(), side(), uniform(0.0, 2.0, 2));
    let mut text = r#"title = "bar"
units = "mm-N-MPa"
mesh.file = "mesh.msh"
[steel]
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
yield_stress = "200 MPa"
hardening_modulus = "1 GPa"
[[support]]
surface = "x_min"
fixed = "x"
[[support]]
surface = "y_min"
fixed = "y"
[[support]]
surface = "z_min"
fixed = "z"
[[support]]
surface = "z_max"
displacement = { z = 0.02 }
"#
    .to_owned();
    for (name, factor) in [("pull", 1.0), ("back", 0.1)] {
        text += &format!("[[step]]\nname = \"{name}\"\nfactor = {factor}\n");
    }
    let (summary, _) = run(&text, &bar.build().unwrap());
    assert_eq!(summary["step"], "back");
    assert_eq!(summary["unloaded"], Value::Null);
    // Stretched by 1 %, and pressed back by 0.9 % beyond the limit that hardening has raised.
    let peeq = summary["bodies"]["bar"]["peeq_max"].as_f64().unwrap();
    let pulled = (200e3 * 0.01 - 200.0) / (200e3 + 1e3);
    let limit = 200.0 + 1e3 * pulled;
    let more = (200e3 * 0.009 - 2.0 * limit) / (200e3 + 1e3);
    assert!((peeq - (pulled + more)).abs() < 1e-9, "{peeq}");
}

#[test]
fn a_load_that_comes_back_is_the_one_that_acts() {
    for (factors, load) in [
        (&[1.0, 1e-3, 1.0][..], 40.0),
        (&[1.0, 1e-3, 0.5], 20.0),
        (&[1.0, 0.5], 20.0),
        (&[1.0, 1e-3, 1.0, 1e-3, 0.2], 8.0),
    ] {
        let summary = cycled(FORCE, factors);
        assert_eq!(summary["step"], (factors.len() - 1).to_string());
        assert_eq!(summary["unloaded"], Value::Null);
        close(&summary["applied_load"], load, 1e-12);
        close(
            &summary["interfaces"]["upper-lower"]["max_pressure"],
            load / 4.0,
            1e-6,
        );
        for (step, factor) in factors.iter().enumerate() {
            close(&summary["steps"][step]["load"], 40.0 * factor, 1e-12);
            close(&summary["steps"][step]["force"][2], -40.0 * factor, 1e-12);
        }
    }
}

#[test]
fn a_motion_that_goes_back_unloads_where_nothing_presses_any_more() {
    // The elastic part of the two strains is 8 MPa / E and some hardening; the rest of 1e-3 stays.
    for factors in [&[1.0, 0.5][..], &[1.0, 0.0]] {
        let summary = cycled(TRAVEL, factors);
        assert_eq!(summary["step"], "0");
        assert!(summary["unloaded"]["peeq_max"]["lower_block"].as_f64() > Some(9e-4));
    }
    // A hundredth of the travel is a fifth of the elastic part: most of the load is still on.
    let summary = cycled(TRAVEL, &[1.0, 0.99]);
    assert_eq!(
        (&summary["step"], &summary["unloaded"]),
        (&"1".into(), &Value::Null)
    );
    let summary = cycled(TRAVEL, &[1.0, 0.5, 1.0]);
    assert_eq!(
        (&summary["step"], &summary["unloaded"]),
        (&"2".into(), &Value::Null)
    );
}

/// Half discs pressed together by 74.28 N and then pushed by Q = μP/2 with a friction of 0.3: by
/// Cattaneo and Mindlin (Johnson 7.2(d)) a strip of c/a = √(1 - Q/μP) sticks.
#[test]
fn pressed_then_sheared_is_told_as_it_ends() {
    const ACROSS: usize = 8;
    const FRICTION: f64 = 0.3;
    const PRESSED: f64 = 74.279;
    let pushed = 0.5 * FRICTION * PRESSED;
    // The size at which Hertz's half-width is that of the family, in mm: P = π a² E* t / 4R', with
    // the thickness t of an element of the contact and R' of two equal discs.
    let modulus = 210_000.0 / (2.0 * (1.0 - 0.3 * 0.3));
    let per_area =
        std::f64::consts::PI * HALF_WIDTH.powi(3) * modulus / (4.0 * 0.5 * RADIUS * ACROSS as f64);
    let size = (PRESSED / per_area).sqrt();
    let mut mesh = full_twins(&Sizes::with(ACROSS)).unwrap();
    for point in &mut mesh.points {
        *point = point.map(|x| size * x);
    }
    let text = format!(
        r#"title = "press, then shear"
units = "mm-N-MPa"
mesh.file = "mesh.msh"

[steel]
youngs_modulus = 210000.0
poissons_ratio = 0.3
elastic = true

[[contact]]
upper = "cylinder_contact"
lower = "lower_contact"
friction = {FRICTION}

[[rigid_plane]]
name = "P"
surface = "top"
force = {{ y = -{PRESSED} }}

[[rigid_plane]]
name = "Q"
surface = "top"
force = {{ x = {pushed} }}

[[support]]
surface = "bottom"
fixed = "xyz"

[[support]]
surface = "back"
fixed = "z"

[[support]]
surface = "front"
fixed = "z"

[[step]]
name = "normal"
factors = {{ Q = 0 }}

[[step]]
name = "tangential"
"#
    );
    let (summary, printed) = run(&text, &mesh);
    assert_eq!(summary["step"], "tangential");
    assert_eq!(summary["unloaded"], Value::Null);
    close(&summary["applied_load"], pushed.hypot(PRESSED), 1e-12);
    close(&summary["applied_force"][0], pushed, 1e-12);
    close(&summary["applied_force"][1], -PRESSED, 1e-12);
    let interface = &summary["interfaces"]["cylinder_contact-lower_contact"];
    close(&interface["force"][0], pushed, 1e-6);
    close(&interface["force"][1], -PRESSED, 1e-6);
    close(&interface["normal_force"], pushed.hypot(PRESSED), 1e-6);
    assert!(interface["max_slip"].as_f64() > Some(0.0));
    // Two nodes a row. A strip that ends between two rows is known to half a row at either end.
    let counts = &interface["status_counts"];
    let [stick, slip] = ["stick", "slip"].map(|s| counts[s].as_f64().unwrap() / 2.0);
    let stuck = 0.5 * stick / ACROSS as f64;
    assert!(
        (stuck - 0.5f64.sqrt()).abs() <= 0.5 / ACROSS as f64,
        "c/a = {stuck}"
    );
    assert!(slip > 0.0);
    // All loads and readings side by side; before the push nothing shears.
    let steps = summary["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 2);
    close(&steps[0]["load"], PRESSED, 1e-12);
    close(&steps[0]["factors"]["Q"], 0.0, 0.0);
    let sheared = |step: &Value| {
        step["interfaces"]["cylinder_contact-lower_contact"]["force"][0]
            .as_f64()
            .unwrap()
    };
    assert!(sheared(&steps[0]).abs() < 1e-6 * PRESSED);
    close(
        &steps[1]["interfaces"]["cylinder_contact-lower_contact"]["force"][0],
        pushed,
        1e-6,
    );
    assert_eq!(
        (&steps[0]["reported"], &steps[1]["reported"]),
        (&false.into(), &true.into())
    );
    assert!(
        printed.contains("the end of step “tangential”"),
        "{printed}"
    );
    assert!(printed.contains("75.11 N (11.14, -74.28, 0)"), "{printed}");
}
