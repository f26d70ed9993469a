//! Combinations of actions: what each is as a case, which one governs, one page for all.

use brinell::case::combinations::{Combination, combinations_of};
use brinell::case::{Kind, parse};
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::mesh::msh::write::msh41;
use brinell::product::combinations::{self, parts};
use brinell::product::job::Options;
use brinell::render::joint::{governing, governs};
use brinell::solver::solve::Silent;

const BEARING: &str = r#"
title = "a bearing"
units = "in-kip-ksi"
[bearing]
friction = 0.15
roller_diameter = "3 in"
roller_wall = "0.75 in"
roller_length = "8 in"
offset = 0
slope = "4 deg"
plate_thickness = "1 in"
[mesh]
preset = "report-like"
[steel]
youngs_modulus = "29500 ksi"
poissons_ratio = 0.3
yield_stress = "100 ksi"
elastic = false
[[action]]
name = "permanent"
load = "30 kip"
[[action]]
name = "traffic"
load = "88.96443230521 kN"
"#;

const FACTORS: &str = r#"
[[combination]]
name = "service"
factors = { permanent = 1, traffic = 1 }
[[combination]]
name = "ultimate: traffic"
factors = { permanent = 1.35, traffic = 1.5 }
[[combination]]
name = "permanent alone"
factors = { permanent = "135 %" }
"#;

fn all(text: &str) -> Vec<Combination> {
    combinations_of("case.toml", text).unwrap().unwrap()
}

#[test]
fn a_bearing_carries_the_sum_of_its_actions() {
    let all = all(&format!("{BEARING}{FACTORS}"));
    let loads = all.iter().map(|one| match &one.case.kind {
        Kind::Bearing(bearing) => bearing.load,
        _ => panic!("a bearing is expected"),
    });
    // 88.964 kN are 20 kip.
    for (load, wanted) in loads.zip([50.0, 1.35 * 30.0 + 1.5 * 20.0, 40.5]) {
        assert!((load - wanted).abs() < 1e-9 * wanted, "{load} {wanted}");
    }
    assert_eq!(all[1].acts(), "1.35 permanent + 1.5 traffic");
    assert_eq!(all[0].case.title, "a bearing: service");
    let one = combinations_of("case.toml", "units = \"m-N-Pa\"\n");
    assert!(matches!(one, Ok(None)));
}

#[test]
fn what_is_wrong_is_told() {
    #[track_caller]
    fn refused(text: &str, says: &str) {
        let error = combinations_of("case.toml", text).unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    }
    let with = |more: &str| format!("{BEARING}{more}");
    refused(BEARING, "no combination");
    refused(&with("[[combination]]\nname = \"a\"\n"), "factors");
    refused(
        &with("[[combination]]\nname = \"a\"\nfactors = { wind = 1 }\n"),
        "wind",
    );
    refused(
        &with("[[combination]]\nname = \"a\"\nfactors = {}\n"),
        "no action",
    );
    refused(
        &with("[[combination]]\nname = \"a\"\nfactor = 1\n"),
        "factor",
    );
    let twice = "[[combination]]\nname = \"a\"\nfactors = { traffic = 1 }\n";
    refused(&with(&format!("{twice}{twice}")), "another combination");
    let loaded = BEARING.replace("friction = 0.15", "friction = 0.15\nload = 65");
    refused(&format!("{loaded}{FACTORS}"), "load");
    let named = BEARING.replace("load = \"30 kip\"", "loads = [\"top\"]");
    refused(&format!("{named}{FACTORS}"), "general scene");
    // As one case it is refused, with what to do.
    let error = parse("case.toml", &with(FACTORS)).unwrap_err();
    assert!(
        error.to_string().contains("combinations of actions"),
        "{error}"
    );
}

/// A scene whose actions are loads by name: a combination is a step with their factors.
#[test]
fn the_actions_of_a_scene_are_its_loads() {
    let scene = r#"
units = "mm-N-MPa"
[mesh]
file = "a.msh"
[steel]
youngs_modulus = 210000
poissons_ratio = 0.3
elastic = true
[[pressure]]
name = "snow"
surface = "top"
value = 1
[[pressure]]
name = "wind"
surface = "side"
value = 2
[[action]]
name = "weather"
loads = ["snow", "wind"]
[[action]]
name = "gusts"
loads = ["wind"]
[[combination]]
name = "all"
factors = { weather = 1.5, gusts = 0.5 }
[[combination]]
name = "a gust"
factors = { gusts = 2 }
"#;
    let all = all(scene);
    // An action that a combination does not name does not act, and what belongs to none always does.
    for (one, wanted) in all.iter().zip([[1.5, 2.0, 1.0], [0.0, 2.0, 1.0]]) {
        let Kind::General(general) = &one.case.kind else {
            panic!("a scene is expected")
        };
        let [step] = &general.model.loads.steps[..] else {
            panic!("one step is expected")
        };
        assert_eq!(
            ["snow", "wind", "dead"].map(|load| step.factor_of(load)),
            wanted
        );
    }
}

#[test]
fn each_is_solved_and_the_governing_one_is_named() {
    let all = all(&format!("{BEARING}{FACTORS}"));
    let folder = tempfile::tempdir().unwrap();
    let options = Options {
        out: Some(folder.path().to_owned()),
        elastic_peaks: true,
        report: true,
        ..Options::default()
    };
    let (solved, ended) = combinations::solve(&all, &options, &mut Silent);
    ended.unwrap();
    let parts = parts(&solved);
    assert_eq!(governs(&parts), Some(1));
    let used: Vec<f64> = parts
        .iter()
        .map(|part| governing(part.summary.unwrap()).unwrap().utilisation)
        .collect();
    assert!(used[1] > used[0] && used[0] > used[2], "{used:?}");
    // Contact is not linear: 1.41 times the load is less than 1.41 times the pressure, about its root.
    let pressure = |part: usize| {
        let lines = &parts[part].summary.unwrap().sizing.as_ref().unwrap().lines;
        lines
            .iter()
            .map(|line| line.hertz_pressure)
            .fold(0.0, f64::max)
    };
    let grown = pressure(1) / pressure(0);
    assert!(
        (grown / (70.5f64 / 50.0).sqrt() - 1.0).abs() < 0.03,
        "{grown}"
    );
    // What governs is what the digest of that run says, and no rule about loads.
    let most = governing(parts[1].summary.unwrap()).unwrap();
    let told = brinell::render::digest::digest(parts[1].summary.unwrap(), &[]);
    let line = told.lines().find(|line| line.contains("governs")).unwrap();
    let against = most.what.rsplit(", of ").next().unwrap();
    assert!(line.ends_with(against), "{line}: {}", most.what);
    combinations::write("a bearing", &solved, true, folder.path()).unwrap();
    let text = std::fs::read_to_string(folder.path().join("combinations.json")).unwrap();
    let record: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(record["governs"], "ultimate: traffic");
    assert_eq!(record["combinations"][2]["acts"], "1.35 permanent");
    // Sizing rules that are missed are limits that are missed.
    let missed = record["combinations"][1]["missed"].to_string();
    assert!(missed.contains("(2-50)"), "{missed}");
    let page = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    for part in &solved {
        assert!(page.contains(&format!("{}/report.html", part.folder)));
        let own = folder.path().join(&part.folder).join("report.html");
        let own = std::fs::read_to_string(own).unwrap();
        // Both pages tell of the same input, which is kept.
        let case = std::fs::read_to_string(folder.path().join(&part.folder).join("case.toml"));
        let text = all.iter().find(|one| one.name == part.name);
        assert_eq!(case.unwrap(), text.unwrap().case.source.text());
        assert!(own.contains("FNV-1a"));
        assert_eq!(part.case_hash.len(), 16);
        assert!(page.contains(&part.case_hash) && own.contains(&part.case_hash));
    }
    assert!(page.contains("ultimate: traffic governs"));
}

/// A block of 8 MPa yield under 16 and 4 MPa: the first collapses, the second is solved all the same, and the case of
/// either finds its mesh from where it stands. What an earlier run found is gone before.
#[test]
fn one_that_collapses_does_not_stop_the_others() {
    let scene = r#"
units = "mm-N-MPa"
mesh.file = "block.msh"
[steel]
youngs_modulus = 210000
poissons_ratio = 0.3
yield_stress = 8
hardening_modulus = 0
[[support]]
surface = "z_min"
fixed = "z"
[[support]]
surface = "x_min"
fixed = "x"
[[support]]
surface = "y_min"
fixed = "y"
[[pressure]]
name = "p"
surface = "z_max"
value = 8
[[action]]
name = "load"
loads = ["p"]
[[combination]]
name = "twice"
factors = { load = 2 }
[[combination]]
name = "half"
factors = { load = 0.5 }
"#;
    let folder = tempfile::tempdir().unwrap();
    let side = || uniform(0.0, 1.0, 1);
    let block = Block::new("block", side(), side(), side()).build().unwrap();
    std::fs::write(folder.path().join("block.msh"), msh41(&block)).unwrap();
    let path = folder.path().join("case.toml").display().to_string();
    let all = combinations_of(&path, scene).unwrap().unwrap();
    let out = folder.path().join("out");
    let earlier = ["combinations.json", "report.html", "1-twice/summary.json"];
    std::fs::create_dir_all(out.join("1-twice")).unwrap();
    for file in earlier {
        std::fs::write(out.join(file), "earlier").unwrap();
    }
    let options = Options {
        out: Some(out.clone()),
        ..Options::default()
    };
    let (solved, ended) = combinations::solve(&all, &options, &mut Silent);
    ended.unwrap();
    assert!(!out.join(earlier[0]).exists() && !out.join(earlier[1]).exists());
    let summary = std::fs::read_to_string(out.join(earlier[2])).unwrap_or_default();
    assert_ne!(summary, "earlier");
    assert!(solved[0].found.is_err() && solved[1].found.is_ok());
    assert_eq!(governs(&parts(&solved)), Some(0));
    combinations::write("a block", &solved, true, &out).unwrap();
    let text = std::fs::read_to_string(out.join(earlier[0])).unwrap();
    let record: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(record["governs"], "twice");
    assert_eq!(record["combinations"][0]["verdict"], "No answer.");
    assert_eq!(record["combinations"][1]["applied_load"], 4.0);
    for part in &solved {
        let case = brinell::case::read(&out.join(&part.folder).join("case.toml")).unwrap();
        brinell::product::job::find_mesh(&case, None, &mut |_| ()).unwrap();
    }
}
