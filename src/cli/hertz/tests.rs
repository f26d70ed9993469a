use clap::Parser;
use miette::Diagnostic;

use super::*;

#[derive(Parser)]
struct Command {
    #[command(flatten)]
    hertz: HertzArgs,
}

/// The words of a line; an underscore stands for a blank within one.
fn ask(words: &str) -> Result<String, HertzError> {
    let words = words.split_whitespace().map(|word| word.replace('_', " "));
    let words = std::iter::once("hertz".to_owned()).chain(words);
    answer(&Command::try_parse_from(words).unwrap().hertz)
}

#[track_caller]
fn prints(line: &str, rows: &[&str]) {
    let text = ask(line).unwrap();
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for row in rows {
        assert!(words.contains(row), "{row} in\n{text}");
    }
}

#[track_caller]
fn refuses(line: &str, message: &str, help: &str) {
    let error = ask(line).unwrap_err();
    assert_eq!(error.to_string(), message);
    let advice = error
        .help()
        .map(|help| help.to_string())
        .unwrap_or_default();
    assert!(advice.contains(help), "{advice}");
}

const STUDY: &str = "--units in-kip-ksi --diameter 3 --wall 0.75 --length 8 --load 65 --yield 100 \
                     --friction 0.15 --groove-angle 4 --offset 1.25 --plate-thickness 1";

/// A roller of 160 mm, S355: 1500 N/mm.
const BRIDGE: &str = "--diameter 160_mm --length 400_mm --load 600_kN --steel S355";

#[test]
fn table_of_the_study() {
    let rows = [
        "peak pressure p0 167.17 ksi",
        "roller 93.202 ksi",
        "7.7832 24.636 in²",
        "(2-49) 7.915 165.0",
    ];
    prints(STUDY, &rows);
    let text = ask(STUDY).unwrap();
    let (before, _) = text.split_once("Design rules").unwrap();
    assert!(
        before.lines().all(|line| line.chars().count() < 80),
        "{text}"
    );
}

#[test]
fn json_of_the_study() {
    let text = ask(&format!("{STUDY} --json")).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(value["units"], "in-kip-ksi");
    assert_eq!(value["input"]["diameter"], 3.0);
    assert_eq!(value["answer"]["within_limit"], false);
    assert_eq!(value["answer"]["line_load"], 8.125);
    let rule = &value["rules"][0];
    assert_eq!(rule["name"], "(2-49)");
    assert_eq!(rule["limit"]["holds"]["pressure"], 165.0);
    // (2-51): the load is on 8 - 2 · 1.25 in.
    assert_eq!(rule["even"]["line_load"], 65.0 / 5.5);
    assert_eq!(rule["even"]["verdict"], "NOT met");
    let en = value["rules"].as_array().unwrap().iter();
    let en = en.clone().find(|rule| rule["name"] == "EN 1337-4").unwrap();
    assert_eq!(en["limit"]["needs"], "the ultimate strength of both steels");
    assert!(en["even"].is_null());
}

#[test]
fn quantities_in_any_unit_say_the_same() {
    let own = "--diameter 3_in --wall 0.75_in --length 8_in --load 65_kip --yield 100_ksi --groove-angle 4_deg";
    let metric = "--diameter 76.2_mm --wall 1.905_cm --length 0.2032_m --load 65_kip --yield 100000_psi \
                  --groove-angle 0.06981317007977318_rad";
    assert_eq!(ask(own).unwrap(), ask(metric).unwrap());
    let bare = "--units in-kip-ksi --diameter 3 --wall 0.75 --length 8 --load 65 --yield 100 --groove-angle 4";
    assert_eq!(ask(own).unwrap(), ask(bare).unwrap());
    // The load says in which units to answer, unless that is said.
    prints(
        "--diameter 80_mm --length 1_m --load 500_kN --yield 355_MPa",
        &["500.00 N/mm"],
    );
    prints(
        "--diameter 80_mm --length 1_m --load 500_kN --yield 355_MPa --units m-N-Pa",
        &["5.0000e5 N/m".replace("5.0000e5", "500000").as_str()],
    );
}

#[test]
fn rules_of_a_steel_by_name() {
    // S355 in 160 mm: f_y = 285, f_u = 450; 23 · 80 · 450² / 210000 = 1774.3.
    prints(
        BRIDGE,
        &[
            "EN 1337-4 1774 902.5 1500 84.5 % indicative: within EN 1337-4:2004",
            "EN 13001-3-3, static: left out, needs the Brinell hardness of both steels",
            "elastic shakedown 943.6 658.2 1500 126 % beyond",
        ],
    );
    // A plate of 30 mm of the same steel is stronger: the roller decides.
    prints(
        &format!("{BRIDGE} --plate-thickness 30_mm --hardness 180 --rollings 1e5"),
        &["EN 1337-4 1774", "EN 13001-3-3, fatigue 1709"],
    );
    prints(
        &format!("{BRIDGE} --plate-steel 42CrMo4 --plate-thickness 80_mm"),
        &["EN 1337-4 1774"],
    );
    prints(
        &format!("{BRIDGE} --rotation 60_mrad"),
        &["EN 1337-4: does not apply: rotation in rad is 0.06, but it must be at most 0.05"],
    );
    assert!(!ask(BRIDGE).unwrap().contains("EN 1337-4: met"));
}

#[test]
fn what_is_wrong_is_named_with_a_way_out() {
    let words = "--units in-kip-ksi --diameter 3 --length 8 --load=-65 --yield 100";
    refuses(words, "load is -65, but it must be positive and finite", "");
    refuses(
        "--diameter 3 --length 8_in --load 65_kip --yield 100_ksi",
        "--diameter 3 has no unit",
        "write --diameter \"3 in\", in quotes and in any unit, or name the units of all bare numbers: --units in-kip-ksi",
    );
    refuses(
        "--diameter 160_mm --length 400 --load 600_kN --yield 355_MPa",
        "--length 400 has no unit",
        "--length \"400 mm\"",
    );
    refuses(
        "--diameter 3_in --length 8_ksi --load 65_kip --yield 100_ksi",
        "--length: `8 ksi` is a stress; a length is wanted: in, ft, mil, m, cm, mm, µm",
        "in quotes",
    );
    refuses(
        "--units mm-N-MPa --diameter 3_% --length 8 --load 65 --yield 100",
        "--diameter: `3 %` is a number without a unit; a length is wanted: in, ft, mil, m, cm, mm, µm",
        "",
    );
    refuses(
        "--diameter 160_mm --length 400_mm --load 600_kN",
        "the yield stress of the roller is not known",
        "--yield \"355 MPa\"",
    );
    refuses(
        "--diameter 160_mm --length 400_mm --load 600_kN --steel S365",
        "no steel is called `S365`",
        "the nearest are: S355",
    );
    refuses(
        "--diameter 300_mm --length 700_mm --load 600_kN --steel S355",
        "`S355` is made up to 250 mm, and not 300 mm thick",
        "275 MPa to 250 mm",
    );
    refuses(
        &format!("{BRIDGE} --grades /nowhere/steels.toml"),
        "the grades /nowhere/steels.toml cannot be read: No such file or directory (os error 2)",
        "",
    );
}
