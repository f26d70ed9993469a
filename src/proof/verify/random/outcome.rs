//! What came of a random case, beside what is known of it.

use super::known::{KnownOfCase, StaticBalance};
use super::watch::RandomWatch;
use miette::Diagnostic;

/// Of a case that took longer than it may.
pub const NOT_FINISHED: &str = "not finished in 120 s";

/// How a case ended.
#[derive(Debug, Clone, PartialEq)]
pub enum RandomVerdict {
    /// Solved, and all that is checked holds.
    Solved,
    /// Solved, and Brinell says itself that the mesh is too coarse: the bodies overlap.
    Doubted {
        why: String,
    },
    /// Refused, and what is known of the case says the same.
    Refused {
        why: String,
    },
    /// Solved, though it cannot be, or with an answer that fails a check.
    Wrong {
        why: String,
    },
    /// Neither solved nor refused for a reason that is known to hold.
    Unexplained {
        why: String,
    },
    Panicked,
}

/// A case and what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomOutcome {
    pub name: String,
    pub verdict: RandomVerdict,
    pub iterations: usize,
    /// Of the accepted increment that took the most.
    pub most: usize,
    pub seconds: f64,
}

impl RandomOutcome {
    pub fn new(name: String, verdict: RandomVerdict, watch: &RandomWatch) -> Self {
        Self {
            name,
            verdict,
            iterations: watch.iterations,
            most: watch.most,
            seconds: watch.seconds(),
        }
    }

    pub fn is_solved(&self) -> bool {
        matches!(
            self.verdict,
            RandomVerdict::Solved | RandomVerdict::Doubted { .. }
        )
    }

    /// Is it an answer that can be believed, or a refusal that is right?
    pub fn holds(&self) -> bool {
        self.is_solved() || matches!(self.verdict, RandomVerdict::Refused { .. })
    }
}

/// Of a case that was solved: which of its checks do not hold, and why its mesh is to be doubted.
pub fn solved(known: &KnownOfCase, failed: Option<String>, doubt: Option<String>) -> RandomVerdict {
    match (known.balance(), failed, doubt) {
        (StaticBalance::None, ..) => RandomVerdict::Wrong {
            why: format!(
                "solved without balance: {}",
                known.missing().unwrap_or_default()
            ),
        },
        (_, Some(why), _) => RandomVerdict::Wrong { why },
        (.., Some(why)) => RandomVerdict::Doubted { why },
        _ => RandomVerdict::Solved,
    }
}

/// Of a case that was refused with this error.
pub fn refused(known: &KnownOfCase, error: &dyn Diagnostic) -> RandomVerdict {
    let code = error.code().map(|code| code.to_string());
    let is = |name: &str| code.as_ref().is_some_and(|code| code.ends_with(name));
    if is("job::interrupted") {
        return late();
    }
    let stands = known.balance() == StaticBalance::Sure;
    let falls = is("solve::no_balance") || is("solve::free_body");
    // Steel that flows without limit ends as one or the other.
    let flows = is("solve::limit_load") || is("solve::not_converged");
    let turns = is("solve::turns_far") && known.turns_far();
    // Such as rollers beyond the edges of their plates.
    let undrawable = is("case::value");
    let why = first_line(error);
    match turns || ((falls || undrawable) && !stands) || (flows && known.is_overloaded()) {
        true => RandomVerdict::Refused { why },
        false => RandomVerdict::Unexplained { why },
    }
}

/// Of a case that was not finished in time.
pub fn late() -> RandomVerdict {
    RandomVerdict::Unexplained {
        why: NOT_FINISHED.into(),
    }
}

fn first_line(error: &dyn Diagnostic) -> String {
    let message = error.to_string();
    message.lines().next().unwrap_or_default().to_owned()
}
