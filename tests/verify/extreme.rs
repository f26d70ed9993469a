//! The extreme cases that take seconds; `brinell verify --suite extreme` runs all of them.

use brinell::proof::verify::extreme;
use std::path::Path;

#[test]
fn extreme_cases_end_as_expected() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/extreme");
    let cases = extreme::read(&folder.join("suite.toml")).unwrap();
    assert!(cases.len() >= 40, "{} cases", cases.len());
    let quick = cases.iter().filter(|case| !case.slow);
    let outcomes = quick.map(|case| case.run(&folder));
    let failed = outcomes.filter(|outcome| !outcome.holds());
    let failed: Vec<String> = failed.map(|outcome| extreme::line(&outcome)).collect();
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

#[test]
fn a_wrong_value_and_a_case_that_should_be_refused_are_told() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/extreme");
    let cases = extreme::read(&folder.join("suite.toml")).unwrap();
    let stack = cases.iter().find(|c| c.expect.contains_key("/descent"));
    let mut case = stack.unwrap().clone();
    case.expect.insert("/descent".into(), 1.0);
    assert!(matches!(
        case.run(&folder).verdict,
        extreme::ExtremeVerdict::Wrong { .. }
    ));
    case.expect.clear();
    case.refused = vec!["solve::free_body".into()];
    assert!(!case.run(&folder).holds());
    case.set.insert("contact".into(), toml_array());
    assert!(case.run(&folder).holds());
    case.iterations = 0;
    assert_eq!(case.run(&folder).verdict, extreme::ExtremeVerdict::Endless);
}

fn toml_array() -> toml::Value {
    toml::Value::Array(Vec::new())
}
