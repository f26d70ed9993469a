//! `brinell size --verify`, on the coarsest mesh.

use super::{brinell, contains};
use serde_json::Value;
use std::path::Path;

const INTERFACES: [&str; 4] = [
    "upper_plate-upper_roller",
    "upper_roller-intermediate_plate",
    "intermediate_plate-lower_roller",
    "lower_roller-lower_plate",
];

const BODIES: [&str; 5] = [
    "upper_plate",
    "upper_roller",
    "intermediate_plate",
    "lower_roller",
    "lower_plate",
];

fn size<'a>(mesh: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let start = [
        "size", "--load", "65 kip", "--yield", "100 ksi", "--mesh", mesh, "--quiet",
    ];
    start
        .into_iter()
        .chain(more.iter().copied())
        .chain(["--verify", "--out", "b"])
        .collect()
}

fn verdict(folder: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join("verdict.json")).unwrap()).unwrap()
}

/// Centre and displaced: every line of contact and every part has its checks, from the summaries of
/// the runs; given again, it goes on from what there is and says the same.
#[test]
fn a_verdict_on_every_part_and_line() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = size("report-like", &["--capacity", "2.5 in", "--margin", "1.6"]);
    let first = brinell(folder.path(), &arguments);
    let met = verdict(&folder.path().join("b"));
    let status = i32::from(!met["met"].as_bool().unwrap());
    let first = first.code(status);
    contains(
        &first.get_output().stdout,
        &["VERDICT:", "b/displaced/displaced.pvd"],
    );
    let positions = met["positions"].as_array().unwrap();
    assert_eq!(positions.len(), 2);
    assert_eq!(positions[1]["offset"], 1.25);
    let mut missed = false;
    for placed in positions {
        let name = placed["position"].as_str().unwrap();
        let path = folder.path().join("b").join(name);
        let summary = std::fs::read(path.join("summary.json")).unwrap();
        let summary: Value = serde_json::from_slice(&summary).unwrap();
        assert!(path.join(format!("{name}.pvd")).is_file());
        let checks = placed["checks"].as_array().unwrap();
        let of = |kind: &str, place: &str| {
            let mut found = checks
                .iter()
                .filter(|c| c["kind"] == kind && c["where"] == place);
            let check = found
                .next()
                .unwrap_or_else(|| panic!("no {kind} of {place}"))
                .clone();
            missed_is_consistent(&check);
            check
        };
        for interface in INTERFACES {
            let check = of("contact_pressure", interface);
            let lines = summary["sizing"]["lines"].as_array().unwrap();
            let line = lines.iter().find(|l| l["interface"] == interface).unwrap();
            assert_eq!(check["line_load"], line["peak_line_load"]);
            assert_eq!(check["value"], line["hertz_pressure"]);
            assert_eq!(check["limit"].as_f64().unwrap(), 1.65 * 100.0);
            // As the certificate has it, or by the line load, with whose root p0 goes.
            let claims = summary["certificate"].as_array().unwrap();
            let share = |what: &str| {
                let is_claim = |c: &&Value| c["what"] == what && c["where"] == interface;
                claims.iter().find(is_claim)?["relative_error"].as_f64()
            };
            let of_load = share("line_load").map(|share| 0.5 * share);
            let wanted = match line["merged"].as_bool().unwrap() {
                // From half of the load to all of it.
                true => Some(1.0 - 0.5f64.sqrt()),
                false => share("hertz_pressure").or(of_load),
            };
            let error = check["error"].as_f64();
            assert_eq!(error.is_some(), wanted.is_some());
            if let Some((error, share)) = error.zip(wanted) {
                let wanted = share * check["value"].as_f64().unwrap();
                assert!((error - wanted).abs() <= 1e-9 * wanted, "{error} {wanted}");
            }
        }
        for body in BODIES {
            let mises = of("elastic_mises", body);
            assert_eq!(mises["limit"], 100.0);
            let strain = of("plastic_strain", body);
            let most = summary["bodies"][body]["peeq_max"].as_f64().unwrap();
            let away = strain["value"].as_f64().unwrap();
            assert!(away <= most);
            assert_eq!(strain["standing"] == "met", away == 0.0);
        }
        missed |= checks
            .iter()
            .any(|c| c["standing"].as_str().unwrap().starts_with("missed"));
    }
    // What a mesh this coarse does not resolve has no verdict.
    let positions = met["positions"].as_array().unwrap().iter();
    let mut checks = positions.flat_map(|p| p["checks"].as_array().unwrap());
    let unresolved = checks.any(|c| c["standing"] == "unresolved");
    assert_eq!(met["met"], !missed && !unresolved);
    assert_eq!(met["advice"].is_null(), !missed);

    brinell(folder.path(), &arguments).code(status);
    let again = verdict(&folder.path().join("b"));
    for (one, other) in met["positions"]
        .as_array()
        .unwrap()
        .iter()
        .zip(again["positions"].as_array().unwrap())
    {
        for (a, b) in one["checks"]
            .as_array()
            .unwrap()
            .iter()
            .zip(other["checks"].as_array().unwrap())
        {
            assert_eq!(a["standing"], b["standing"]);
            let (a, b) = (a["value"].as_f64().unwrap(), b["value"].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-7 * a.abs(), "{a} {b}");
        }
    }
}

#[track_caller]
fn missed_is_consistent(check: &Value) {
    let (Some(value), Some(limit)) = (check["value"].as_f64(), check["limit"].as_f64()) else {
        return;
    };
    let standing = check["standing"].as_str().unwrap();
    if standing != "open" {
        assert_eq!(standing.starts_with("missed"), value > limit, "{check}");
    }
}

/// A roller that is far too small: status 1, the misses by name, what would help, and with --tries the
/// design that does.
#[test]
fn a_failure_says_what_would_help() {
    let folder = tempfile::tempdir().unwrap();
    let small = [
        "--capacity",
        "0 in",
        "--diameter",
        "2 in",
        "--length",
        "5 in",
    ];
    let assert = brinell(folder.path(), &size("report-like", &small)).code(1);
    let output = &assert.get_output().stdout;
    contains(
        output,
        &[
            "VERDICT: FAILED",
            "p0 of",
            "what would help: --rule eccentric --margin",
        ],
    );
    let out = folder.path().join("b");
    let verdict = verdict(&out);
    assert_eq!(verdict["met"], false);
    assert!(verdict["advice"]["diameter"].as_f64().unwrap() > 2.0);
    assert!(!out.join("displaced").exists());
    let page = std::fs::read_to_string(out.join("verdict.md")).unwrap();
    assert!(page.starts_with("# Verdict: MISSED"));

    let tries = [&small[..], &["--tries", "4"]].concat();
    let assert = brinell(folder.path(), &size("h0125", &tries)).code(0);
    contains(
        &assert.get_output().stdout,
        &["VERDICT: FAILED", "VERDICT: no limit is missed"],
    );
    assert!(out.join("design-1/verdict.json").is_file());
    assert!(out.join("design-2/centre/summary.json").is_file());
}
