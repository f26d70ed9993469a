//! Whatever the text of a sweep file is: rows in folders of their own, or an error that can be shown.
#![no_main]

use brinell::product::sweep::{self, Sweep};
use libfuzzer_sys::fuzz_target;
use std::collections::HashSet;
use std::path::Path;

/// The case that is varied, whatever the sweep names.
const CASE: &str = include_str!("../../cases/extreme/stack.toml");

/// Rows that are made of it; more take long, and show nothing new.
const MOST: usize = 32;

fuzz_target!(|text: &str| {
    let file = Path::new("fuzz.toml");
    let mut plan = match sweep::parse(file, text) {
        Ok(plan) => plan,
        Err(error) => return drop(format!("{:?}", miette::Report::new(error))),
    };
    assert!(!plan.rows.is_empty());
    plan.rows.truncate(MOST);
    let sweep = Sweep::of(plan, file, CASE.to_owned());
    let names: HashSet<&str> = sweep.rows.iter().map(|row| row.name.as_str()).collect();
    assert_eq!(names.len(), sweep.rows.len());
    let fine = |c: char| c.is_ascii_alphanumeric() || "._+-".contains(c);
    assert!(names.iter().all(|name| name.chars().all(fine)), "{names:?}");
    if let Err(error) = sweep.validate() {
        drop(format!("{:?}", miette::Report::new(error)));
    }
});
