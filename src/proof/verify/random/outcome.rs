//! What came of a random case, beside what is known of it.

use super::known::{Balance, Known};
use super::watch::Watch;
use miette::Diagnostic;

/// Of a case that took longer than it may.
pub const LATE: &str = "not finished in 120 s";

/// How a case ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
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
pub struct Outcome {
    pub name: String,
    pub verdict: Verdict,
    pub iterations: usize,
    /// Of the accepted increment that took the most.
    pub most: usize,
    pub seconds: f64,
}

impl Outcome {
    pub fn new(name: String, verdict: Verdict, watch: &Watch) -> Self {
        Self {
            name,
            verdict,
            iterations: watch.iterations,
            most: watch.most,
            seconds: watch.seconds(),
        }
    }

    pub fn is_solved(&self) -> bool {
        matches!(self.verdict, Verdict::Solved | Verdict::Doubted { .. })
    }

    /// Is it an answer that can be believed, or a refusal that is right?
    pub fn holds(&self) -> bool {
        self.is_solved() || matches!(self.verdict, Verdict::Refused { .. })
    }
}

/// Of a case that was solved: which of its checks do not hold, and why its mesh is to be doubted.
pub fn solved(known: &Known, failed: Option<String>, doubt: Option<String>) -> Verdict {
    match (known.balance(), failed, doubt) {
        (Balance::None, ..) => Verdict::Wrong {
            why: format!(
                "solved without balance: {}",
                known.missing().unwrap_or_default()
            ),
        },
        (_, Some(why), _) => Verdict::Wrong { why },
        (.., Some(why)) => Verdict::Doubted { why },
        _ => Verdict::Solved,
    }
}

/// Of a case that was refused with this error.
pub fn refused(known: &Known, error: &dyn Diagnostic) -> Verdict {
    let code = error.code().map(|code| code.to_string());
    let is = |name: &str| code.as_ref().is_some_and(|code| code.ends_with(name));
    if is("job::interrupted") {
        return late();
    }
    let stands = known.balance() == Balance::Sure;
    let falls = is("solve::no_balance") || is("solve::free_body");
    // Steel that flows without limit ends as one or the other.
    let flows = is("solve::limit_load") || is("solve::not_converged");
    let turns = is("solve::turns_far") && known.turns_far();
    // Such as rollers beyond the edges of their plates.
    let undrawable = is("case::value");
    let why = first_line(error);
    match turns || ((falls || undrawable) && !stands) || (flows && known.is_overloaded()) {
        true => Verdict::Refused { why },
        false => Verdict::Unexplained { why },
    }
}

/// Of a case that was not finished in time.
pub fn late() -> Verdict {
    Verdict::Unexplained { why: LATE.into() }
}

fn first_line(error: &dyn Diagnostic) -> String {
    let message = error.to_string();
    message.lines().next().unwrap_or_default().to_owned()
}
