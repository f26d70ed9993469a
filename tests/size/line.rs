//! `brinell size --template line`: parallel rollers.

use super::{brinell, contains};
use brinell::case::{self, Kind};
use serde_json::Value;
use std::f64::consts::PI;

const BRIDGE: [&str; 9] = [
    "size",
    "--template",
    "line",
    "--load",
    "450 kN",
    "--yield",
    "460 MPa",
    "--modulus",
    "210 GPa",
];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    BRIDGE.iter().copied().chain(more.iter().copied()).collect()
}

fn json(path: &std::path::Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

/// L = margin P / q, q = p² π R C_E with p = 1.65 σ_y and C_E = 2 (1 − ν²)/E, rounded up to 5 mm.
#[test]
fn a_length_by_hand() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = with(&["--diameter", "200 mm", "--out", "r"]);
    let assert = brinell(folder.path(), &arguments).code(0);
    contains(
        &assert.get_output().stdout,
        &["Recommended (<): one roller 200 mm x 320 mm, plates 300 mm x 320 mm x 60 mm"],
    );
    let size = json(&folder.path().join("r/size.json"));
    let first = &size["candidates"][0];
    let most = (1.65f64 * 460.0).powi(2) * PI * 100.0 * 2.0 * 0.91 / 210e3;
    let wanted = 1.1 * 450e3 / most;
    let asked = first["required_length"].as_f64().unwrap();
    assert!((asked / wanted - 1.0).abs() < 1e-9, "{asked} {wanted}");
    let share = first["even"]["utilisation"].as_f64().unwrap();
    assert!((share - (wanted / 1.1 / 320.0).sqrt()).abs() < 1e-9);
    let case = case::read(&folder.path().join("r/line.toml")).unwrap();
    let Kind::Bearing(bearing) = &case.kind else {
        panic!("a bearing")
    };
    assert_eq!(bearing.load, 450e3);
    assert_eq!(bearing.layout().length(), 320.0);
    assert_eq!(bearing.layout().wall(), None);
}

/// Where diameter and length are given the number of rollers is what is left.
#[test]
fn as_few_rollers_as_will_do() {
    let folder = tempfile::tempdir().unwrap();
    let given = ["--diameter", "100 mm", "--length", "250 mm", "--out", "r"];
    let assert = brinell(folder.path(), &with(&given)).code(0);
    contains(
        &assert.get_output().stdout,
        &["Recommended (<): 3 rollers, 140 mm apart, 100 mm x 250 mm"],
    );
    let case = case::read(&folder.path().join("r/line.toml")).unwrap();
    let Kind::Bearing(bearing) = &case.kind else {
        panic!("a bearing")
    };
    assert_eq!(bearing.layout().rollers(true).len(), 3);
    // Too many for any twelve: none is recommended, and the status says so.
    let short = with(&["--diameter", "20 mm", "--length", "50 mm", "--out", "s"]);
    let assert = brinell(folder.path(), &short).code(1);
    contains(&assert.get_output().stdout, &["None is recommended"]);
}

#[test]
fn what_says_nothing_of_a_template_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (more, words) in [
        (vec!["--capacity", "3 in"], "--capacity says nothing"),
        (vec!["--slope", "4 deg"], "--slope says nothing"),
        (
            vec!["--rollers", "13"],
            "--rollers is 13, but it must be from 1 to 12",
        ),
        (vec!["--wall", "0.6"], "--wall is 0.6"),
        (vec!["--rollers", "2", "--spacing", "10 mm"], "spacing = 10"),
    ] {
        let assert = brinell(folder.path(), &with(&more)).code(2);
        contains(&assert.get_output().stderr, &[words]);
    }
    let crossed = ["size", "--load", "65 kip", "--yield", "100 ksi"];
    let assert = brinell(folder.path(), &crossed).code(2);
    contains(&assert.get_output().stderr, &["--capacity is missing"]);
    let more = [&crossed[..], &["--capacity", "3 in", "--rollers", "2"]].concat();
    let assert = brinell(folder.path(), &more).code(2);
    contains(&assert.get_output().stderr, &["--rollers says nothing"]);
}

/// The bearing that is proposed is solved and held against its limits; one that is too short fails, and the verdict asks
/// for more.
#[test]
fn a_proposal_is_verified() {
    let folder = tempfile::tempdir().unwrap();
    let common = ["--verify", "--quiet"];
    let good = [
        "--diameter",
        "200 mm",
        "--length",
        "400 mm",
        "--out",
        "good",
    ];
    brinell(folder.path(), &with(&[&common[..], &good].concat())).code(0);
    let verdict = json(&folder.path().join("good/verdict.json"));
    assert_eq!(verdict["met"], true);
    let checks = verdict["found"]["checks"].as_array().unwrap();
    let pressed = checks.iter().find(|c| c["kind"] == "contact_pressure");
    // Hertz under the even load, and a hundredth or two more in the middle.
    let even = verdict["design"]["even"]["pressure"].as_f64().unwrap();
    let found = pressed.unwrap()["value"].as_f64().unwrap();
    assert!((1.0..1.05).contains(&(found / even)), "{found} {even}");
    let bad = [
        "--diameter",
        "120 mm",
        "--length",
        "300 mm",
        "--margin",
        "1",
        "--limit",
        "2.2",
    ];
    let bad = [&common[..], &bad, &["--rollers", "1", "--out", "bad"]].concat();
    brinell(folder.path(), &with(&bad)).code(1);
}

/// What rounded ends take off does not bear; and where they begin no mesh of these sizes resolves what presses, so that p0 is judged away from there.
#[test]
fn rounded_ends_bear_nothing_and_p0_is_judged_away_from_them() {
    let folder = tempfile::tempdir().unwrap();
    let rounded = [
        "--verify",
        "--quiet",
        "--diameter",
        "200 mm",
        "--length",
        "430 mm",
    ];
    let rounded = [&rounded[..], &["--end", "radius 15 mm", "--out", "rounded"]].concat();
    brinell(folder.path(), &with(&rounded));
    let verdict = json(&folder.path().join("rounded/verdict.json"));
    let even = &verdict["design"]["even"];
    let load = verdict["design"]["rollers"].as_f64().unwrap()
        * even["line_load"].as_f64().unwrap()
        * 400.0;
    assert!((load / 450e3 - 1.0).abs() < 1e-9, "{load}");
    let checks = verdict["found"]["checks"].as_array().unwrap();
    let pressed = checks
        .iter()
        .find(|c| c["kind"] == "contact_pressure")
        .unwrap();
    assert!(pressed["error"].is_number(), "{pressed}");
    assert!(
        pressed["remark"]
            .as_str()
            .unwrap()
            .contains("away from rounded ends")
    );
    let over = pressed["value"].as_f64().unwrap() / even["pressure"].as_f64().unwrap();
    assert!((0.98..1.1).contains(&over), "{over}");
}
