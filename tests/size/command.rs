//! `brinell size` without solving: tables, files, refusals.

use super::{brinell, contains};
use brinell::case;
use serde_json::Value;

const STUDY: [&str; 7] = [
    "size",
    "--load",
    "65 kip",
    "--yield",
    "100 ksi",
    "--capacity",
    "2.5 in",
];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    STUDY.iter().copied().chain(more.iter().copied()).collect()
}

#[test]
fn prints_the_table_and_writes_the_cases() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = with(&["--rule", "printed", "--diameter", "3 in", "--out", "b"]);
    // The verdict on an earlier design is none on this one.
    let verdict = folder.path().join("b/verdict.json");
    std::fs::create_dir(folder.path().join("b")).unwrap();
    std::fs::write(&verdict, "{}").unwrap();
    let assert = brinell(folder.path(), &arguments).code(0);
    let output = &assert.get_output().stdout;
    contains(
        output,
        &[
            "3 0.75 1 7.990 8.212 10.49 10.71",
            "Recommended (<): rollers 3 in x 10.5 in, wall 0.75 in, plates 1 in",
            "beware: displaced, it leans on its end",
            "--plate 1.333 of the wall: no rule",
            "printed, for 1 times the load, as asked",
        ],
    );
    let text = String::from_utf8_lossy(output);
    assert!(
        text.lines().all(|line| line.chars().count() <= 140),
        "{text}"
    );
    assert!(!verdict.exists());
    for name in ["centre", "displaced"] {
        case::read(&folder.path().join(format!("b/{name}.toml"))).unwrap();
    }
    let size = std::fs::read(folder.path().join("b/size.json")).unwrap();
    let size: Value = serde_json::from_slice(&size).unwrap();
    assert_eq!(size["recommended"], 0);
    assert_eq!(size["candidates"][0]["length"], 10.5);
    assert_eq!(size["units"]["length"], "in");
}

#[test]
fn answers_in_the_units_of_the_load() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = [
        "size",
        "--load",
        "289 kN",
        "--yield",
        "100 ksi",
        "--capacity",
        "2.5 in",
    ];
    let assert = brinell(folder.path(), &arguments).code(0);
    contains(
        &assert.get_output().stdout,
        &["Sized for 289000 N", "displacement 2 D_r = 63.5 mm"],
    );
    let arguments = [&arguments[..], &["--units", "m-N-Pa"]].concat();
    let assert = brinell(folder.path(), &arguments).code(0);
    contains(
        &assert.get_output().stdout,
        &["displacement 2 D_r = 0.0635 m"],
    );
    assert!(folder.path().join("results/size/centre.toml").is_file());
}

/// Too steep for the friction, (2-39): told, status 1, and no case is written.
#[test]
fn a_roller_that_slides_is_not_proposed() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = with(&["--slope", "12 deg", "--out", "b"]);
    let assert = brinell(folder.path(), &arguments).code(1);
    contains(
        &assert.get_output().stdout,
        &["None is recommended", "(2-39) allows a slope of 11.3"],
    );
    assert!(!folder.path().join("b").exists());
}

#[test]
fn bad_input_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let cases: [(&[&str], &[&str]); 9] = [
        (
            &["--diameter", "3"],
            &["--diameter: `3` has no unit", "a length is wanted"],
        ),
        (
            &["--diameter", "3 ksi"],
            &["--diameter: `3 ksi` is a stress"],
        ),
        (
            &["--diameter", "-3 in"],
            &["--diameter is -3, but it must be more than 0"],
        ),
        (
            &["--wall", "0.6"],
            &["--wall is 0.6, but it must be from 0.01 to 0.49"],
        ),
        (
            &["--length", "2 in"],
            &["--length is 2, but it must be more than the capacity"],
        ),
        (
            &["--slope", "50 deg"],
            &["--slope is 50", "less than 45 deg"],
        ),
        (
            &["--mesh", "fine"],
            &["--mesh cannot be `fine`", "one of: auto"],
        ),
        (
            &["--units", "furlongs"],
            &["--units cannot be `furlongs`", "in-kip-ksi"],
        ),
        (
            &["--end", "round"],
            &["--end cannot be `round`", "crown 20 µm"],
        ),
    ];
    for (more, said) in cases {
        let assert = brinell(folder.path(), &with(more)).code(2);
        contains(&assert.get_output().stderr, said);
    }
    let assert = brinell(folder.path(), &["size", "--load", "65 kip"]).code(2);
    contains(&assert.get_output().stderr, &["--yield"]);
}
