//! Solving a stack, and the same stack in other guises.

use super::check::{check, overlap};
use super::draw::{self, Stack};
use super::guise::{ROUTE_DIFFERENCE, guises, restated};
use super::split::split;
use crate::answer::certify::DOUBLING;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::proof::verify::random::outcome::{self, RandomVerdict};
use crate::proof::verify::random::watch::RandomWatch;
use crate::solver::solve::{self, SolveError};
use std::time::Duration;

/// Stacks take a second or two on meshes that are split; one that takes longer than this does not come to an end.
const LONGEST_SPLIT: Duration = Duration::from_secs(30);

/// Solves stack `number` of a seed, and the same in other guises.
pub fn solve(seed: u64, number: usize, watch: &mut RandomWatch) -> RandomVerdict {
    let stack = match draw::stack(seed, number) {
        Ok(stack) => stack,
        Err(error) => {
            let why = format!("not meshed: {error}");
            return RandomVerdict::Unexplained { why };
        }
    };
    let answer = match solved(&stack.scene, watch) {
        Ok(Some(answer)) => answer,
        Ok(None) => return outcome::late(),
        Err(error) => return outcome::refused(&stack.known, &error),
    };
    let (wrong, unsolved) = match check(&stack, &answer.state) {
        Some(failed) => (vec![failed], Vec::new()),
        None => {
            let (mut wrong, mut unsolved) = compare(&stack, &answer);
            match split_in_places(&stack, seed, number) {
                Ok(failed) => wrong.extend(failed),
                Err(why) => unsolved.push(why),
            }
            (wrong, unsolved)
        }
    };
    if wrong.is_empty() && !unsolved.is_empty() {
        let why = unsolved.join("; ");
        return RandomVerdict::Unexplained { why };
    }
    let failed = (!wrong.is_empty()).then(|| wrong.join("; "));
    outcome::solved(&stack.known, failed, overlap(&stack, &answer.state))
}

/// The end of the last step.
struct StackAnswer {
    state: State,
    /// The same in increments twice as large, where it depends on them.
    doubled: Option<State>,
    /// Ends of the increments.
    times: Vec<f64>,
}

/// `None` where it took too long.
fn solved(scene: &Scene, watch: &mut RandomWatch) -> Result<Option<StackAnswer>, SolveError> {
    let mut scene = scene.clone();
    let mut solution = solve::solve(&mut scene, watch)?;
    Ok(solution.complete.then(|| StackAnswer {
        state: solution.last,
        doubled: solution.doubled.pop(),
        times: watch.times.clone(),
    }))
}

/// Solves it on a mesh with hanging nodes, whose answer is another one but fulfils the same: what of that it does not, or
/// why there is none.
fn split_in_places(stack: &Stack, seed: u64, number: usize) -> Result<Option<String>, String> {
    let said = |why: String| format!("split in places: {why}");
    let stack = split(stack, seed, number).map_err(|error| said(error.to_string()))?;
    match solved(&stack.scene, &mut RandomWatch::of(LONGEST_SPLIT)) {
        Ok(Some(answer)) => Ok(check(&stack, &answer.state).map(said)),
        Ok(None) => Err(said(format!(
            "not finished in {} s",
            LONGEST_SPLIT.as_secs()
        ))),
        Err(error) => Err(said(error.to_string())),
    }
}

/// Solves the other guises: which of them have another answer, and which have none. Where one was cut back and the
/// other was not, the two answers are off by what increments do to them: no more than twice what that is said to be.
fn compare(stack: &Stack, answer: &StackAnswer) -> (Vec<String>, Vec<String>) {
    let same = restated("as it is", stack.scene.clone(), ROUTE_DIFFERENCE);
    let doubled = answer.doubled.as_ref();
    let of_increments = doubled.map_or(0.0, |d| 2.0 * DOUBLING * same.off(stack, &answer.state, d));
    let (mut differ, mut unsolved) = (Vec::new(), Vec::new());
    for guise in guises(&stack.scene) {
        let what = guise.what;
        match solved(&guise.scene, &mut RandomWatch::start()) {
            Ok(Some(other)) => {
                let off = guise.off(stack, &answer.state, &other.state);
                let cut_back = other.times != answer.times;
                let more = if cut_back { of_increments } else { 0.0 };
                if !(off <= guise.within + more) {
                    differ.push(format!("{what}: the answer differs by {off:.1e}"));
                }
            }
            Ok(None) => unsolved.push(format!("{what}: {}", outcome::NOT_FINISHED)),
            Err(error) => unsolved.push(format!("{what}: {error}")),
        }
    }
    (differ, unsolved)
}
