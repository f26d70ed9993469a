//! The structure of the sources, as ARCHITECTURE.md tells it: ranks of rooms, no circles, small files.

mod imports;

use imports::{Imports, Module};
use std::collections::BTreeMap;
use std::fs;

/// The rooms by rank: each imports only from those before it, or from itself.
const RANKS: [&str; 10] = [
    "ground", "analytic", "model", "solver", "answer", "render", "case", "product", "proof", "cli",
];

/// Of the rooms below `case`, those that it does not need.
const NOT_FOR_CASES: [&str; 3] = ["solver", "answer", "render"];

/// Lines that are neither blank nor comments.
const LONGEST_FILE: usize = 350;
const MEDIAN_FILE: usize = 110;

fn named(module: &Module) -> String {
    module.join("::")
}

#[test]
fn rooms_import_only_from_those_of_lower_rank() {
    let rank = |module: &Module| {
        RANKS
            .iter()
            .position(|room| module.first().is_some_and(|m| m == room))
    };
    let mut wrong = Vec::new();
    for (module, imported) in Imports::read().edges() {
        let (Some(own), Some(other)) = (rank(module), rank(imported)) else {
            continue;
        };
        let not_for_cases = RANKS[own] == "case" && NOT_FOR_CASES.contains(&RANKS[other]);
        if other > own || not_for_cases {
            wrong.push(format!("{} imports {}", named(module), named(imported)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let circles = Imports::read().circles();
    let told: Vec<String> = (circles.iter())
        .map(|circle| circle.iter().map(named).collect::<Vec<_>>().join(", "))
        .collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// What prints and draws takes figures from the answer: of the rooms that compute it imports types, and no function.
#[test]
fn what_renders_computes_nothing() {
    let imports = Imports::read();
    let computes = |path: &[String]| {
        let room = path.first().map(String::as_str);
        let is_function = path
            .last()
            .is_some_and(|item| item.starts_with(char::is_lowercase));
        let is_module = imports.modules().contains(path);
        matches!(room, Some("answer" | "solver" | "analytic")) && is_function && !is_module
    };
    let paths = imports
        .paths()
        .iter()
        .filter(|(module, _)| module.first().is_some_and(|m| m == "render"));
    let wrong: Vec<String> = paths
        .flat_map(|(module, paths)| paths.iter().map(move |path| (module, path)))
        .filter(|(_, path)| computes(path))
        .map(|(module, path)| format!("{} calls {}", named(module), path.join("::")))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn files_are_small() {
    let mut lengths: BTreeMap<String, usize> = BTreeMap::new();
    for path in imports::sources() {
        let text = fs::read_to_string(&path).unwrap();
        let is_code = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//");
        let code = text.lines().filter(is_code).count();
        lengths.insert(path.display().to_string(), code);
    }
    let long = lengths.iter().filter(|(_, lines)| **lines > LONGEST_FILE);
    let long: Vec<String> = long
        .map(|(path, lines)| format!("{path}: {lines} lines"))
        .collect();
    assert!(long.is_empty(), "{}", long.join("\n"));
    let mut sorted: Vec<usize> = lengths.into_values().collect();
    sorted.sort_unstable();
    let median = sorted[sorted.len() / 2];
    assert!(median <= MEDIAN_FILE, "the median file has {median} lines");
}
