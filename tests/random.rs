//! Cases that nobody has chosen: a sample of what `brinell verify --suite random` draws.

use brinell::proof::verify::random::{RandomKind, RandomOutcome, RandomVerdict, run};

#[track_caller]
fn check(kind: RandomKind, seed: u64, numbers: &[usize]) -> Vec<RandomOutcome> {
    let (held, failed) = run_all(kind, seed, numbers);
    assert!(failed.is_empty(), "{failed:#?}");
    held
}

/// Those that hold and those that do not.
fn run_all(
    kind: RandomKind,
    seed: u64,
    numbers: &[usize],
) -> (Vec<RandomOutcome>, Vec<RandomOutcome>) {
    let outcomes = numbers.iter().map(|n| run(kind, seed, *n));
    outcomes.partition(RandomOutcome::holds)
}

/// Also turned, in other units, numbered otherwise, with other penalties, divided, and on meshes with hanging nodes; nine in
/// ten in under 60 iterations an increment. One in forty may have no answer on a mesh that is split anywhere: where bodies
/// all but slide the statuses of their nodes may go round in circles.
#[test]
fn stacks_of_blocks_are_solved_or_refused_as_statics_says() {
    let numbers: Vec<usize> = (0..40).collect();
    let (outcomes, failed) = run_all(RandomKind::Stack, 1, &numbers);
    let is_circle = |o: &RandomOutcome| match &o.verdict {
        RandomVerdict::Unexplained { why } => why.starts_with("split in places: not finished"),
        _ => false,
    };
    assert!(
        failed.len() <= 1 && failed.iter().all(is_circle),
        "{failed:#?}"
    );
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
