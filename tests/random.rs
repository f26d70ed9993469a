//! Cases that nobody has chosen: a sample of what `brinell verify --suite random` draws.

use brinell::proof::verify::random::{RandomKind, RandomOutcome, run};

#[track_caller]
fn check(kind: RandomKind, seed: u64, numbers: &[usize]) -> Vec<RandomOutcome> {
    let outcomes: Vec<RandomOutcome> = numbers.iter().map(|n| run(kind, seed, *n)).collect();
    let failed: Vec<&RandomOutcome> = outcomes.iter().filter(|o| !o.holds()).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    outcomes
}

/// Also turned, in other units, numbered otherwise, with other penalties, and divided; nine in ten in under 60
/// iterations an increment.
#[test]
fn stacks_of_blocks_are_solved_or_refused_as_statics_says() {
    let numbers: Vec<usize> = (0..40).collect();
    let outcomes = check(RandomKind::Stack, 1, &numbers);
    assert!(!outcomes.iter().all(RandomOutcome::is_solved));
    let solved: Vec<&RandomOutcome> = outcomes.iter().filter(|o| o.is_solved()).collect();
    let quick = solved.iter().filter(|o| o.most < 60).count();
    assert!(
        10 * quick >= 9 * solved.len() && solved.len() > 10,
        "{solved:#?}"
    );
}

#[test]
fn bearings_are_solved_or_refused_as_statics_says() {
    let outcomes = check(RandomKind::Bearing, 1, &BEARINGS);
    assert!(outcomes.iter().any(RandomOutcome::is_solved));
    assert!(!outcomes.iter().all(RandomOutcome::is_solved));
}

/// Of a few seconds each: centred ones, a displaced one, and one that slides.
const BEARINGS: [usize; 5] = [4, 5, 11, 13, 42];
