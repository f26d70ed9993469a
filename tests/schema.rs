//! The schemas that are shipped hold for what is shipped: every case file, and the summaries of runs of every kind.

use brinell::case;
use brinell::product::job::{self, Options};
use brinell::solver::solve::Silent;
use jsonschema::Validator;
use serde_json::Value;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn validator(name: &str) -> Validator {
    let path = root().join("docs/schema").join(name);
    let text = std::fs::read_to_string(path).unwrap();
    jsonschema::validator_for(&serde_json::from_str(&text).unwrap()).unwrap()
}

/// What is wrong with `value`, each with its place.
fn errors(validator: &Validator, value: &Value) -> Vec<String> {
    let all = validator.iter_errors(value);
    all.map(|error| format!("{}: {error}", error.instance_path()))
        .collect()
}

fn read(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap();
    let table: toml::Table = toml::from_str(&text).unwrap();
    serde_json::to_value(table).unwrap()
}

/// Every TOML file below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut found: Vec<PathBuf> = entries
        .map(|entry| entry.unwrap().path())
        .flat_map(|path| match path.is_dir() {
            true => files(&path),
            false => vec![path],
        })
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    found.sort();
    found
}

#[test]
fn every_shipped_case_keeps_to_the_schema() {
    let validator = validator("case.schema.json");
    let mut cases = 0;
    for path in files(&root().join("cases")) {
        let value = read(&path);
        // Sweeps and lists of cases are no cases.
        if value.get("grid").is_some() || value.get("case").is_some() {
            continue;
        }
        let wrong = errors(&validator, &value);
        assert!(
            wrong.is_empty(),
            "{}:\n{}",
            path.display(),
            wrong.join("\n")
        );
        cases += 1;
    }
    assert!(cases > 30, "{cases}");
}

/// What the reader refuses for its form the schema refuses, too.
#[test]
fn mistakes_are_no_cases() {
    let validator = validator("case.schema.json");
    let good = read(&root().join("cases/section-2.6.2/initial-centre.toml"));
    let mistakes: [(&str, &str, Value); 7] = [
        ("", "unts", "in-kip-ksi".into()),
        ("", "units", "furlong".into()),
        ("/bearing", "lod", 65.into()),
        ("/bearing", "load", true.into()),
        ("/bearing", "offset_is", "plate".into()),
        ("/controls", "iterations", 0.into()),
        ("/steel", "poissons_ratio", Value::Null),
    ];
    for (table, key, value) in mistakes {
        let mut wrong = good.clone();
        if wrong.pointer(table).is_none() {
            wrong[&table[1..]] = serde_json::json!({});
        }
        wrong.pointer_mut(table).unwrap()[key] = value;
        assert!(!validator.is_valid(&wrong), "{table}/{key}");
    }
    let mut without = good.clone();
    without["bearing"].as_object_mut().unwrap().remove("slope");
    assert!(!validator.is_valid(&without));
}

/// Bearings centred and displaced, elastic and not, with steps and dents; general scenes with and without a line.
#[test]
fn what_runs_print_keeps_to_the_schema() {
    let validator = validator("summary.schema.json");
    for (case, mesh) in [
        ("section-2.6.2/initial-centre", Some("report-like")),
        ("section-2.6.2/revised-offset-1.25", Some("report-like")),
        ("prototype-2", Some("report-like")),
        ("wall-sweep/wall-0.5", Some("report-like")),
        ("problem-h", None),
        ("extreme/stack", None),
        ("extreme/bar", None),
        ("extreme/rough-1", None),
    ] {
        let mut case = case::read(&root().join(format!("cases/{case}.toml"))).unwrap();
        if let Some(preset) = mesh {
            case.set_preset(preset).unwrap();
        }
        let outcome = job::run(&case, &Options::default(), &mut Silent).unwrap();
        let value = serde_json::to_value(&outcome.summary).unwrap();
        let wrong = errors(&validator, &value);
        assert!(wrong.is_empty(), "{}:\n{}", case.title, wrong.join("\n"));
    }
    let nothing = serde_json::json!({ "case": "a case" });
    assert!(!validator.is_valid(&nothing));
}
