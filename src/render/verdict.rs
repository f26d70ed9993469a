//! The verdict: may the answer be used, are the sizing rules met, does steel yield.

use crate::render::figures::share;
use crate::render::summary::Summary;
use crate::render::text::significant;

/// How good the news is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grade {
    /// Nothing to be said against it.
    Good,
    /// To be read with care.
    Care,
    /// Not to be used, or a rule is missed.
    Bad,
}

/// What a run comes to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    pub grade: Grade,
    /// The first sentence,
    pub head: &'static str,
    /// and the others.
    pub rest: Vec<String>,
}

/// The verdict on a run whose checks miss the limits `missed`, in words.
pub fn verdict(summary: &Summary, missed: &[String]) -> Verdict {
    let bad = |head, why| Verdict {
        grade: Grade::Bad,
        head,
        rest: vec![why],
    };
    if !summary.answer.converged {
        let done = share(Some(summary.answer.step_done));
        let why = format!(
            "The solution has not converged: what follows is the last increment that was done, {done} of \
             step “{}”.",
            summary.answer.step
        );
        return bad("No answer.", why);
    }
    if !missed.is_empty() {
        return bad("Not to be relied upon.", format!("{}.", missed.join("; ")));
    }
    let missed = missed_rules(summary);
    let flows =
        (summary.answer.bodies.0.iter()).max_by(|a, b| a.1.peeq_max.total_cmp(&b.1.peeq_max));
    let flows = flows.filter(|(_, body)| body.peeq_max > 0.0);
    let mut rest = Vec::new();
    if !missed.is_empty() {
        rest.push(format!("{}.", missed.join("; ")));
    } else if let Some(rules) = judged_rules(summary) {
        rest.push(format!("{rules} met."));
    }
    match flows {
        Some((name, body)) => rest.push(format!(
            "Plastic strain is up to {} in {name}.",
            significant(body.peeq_max, 2)
        )),
        None if summary.answer.plasticity => rest.push("Nothing yields.".to_string()),
        None => rest.push("Steel is taken as elastic.".to_string()),
    }
    rest.push("The solution has converged, and every check of it is within its limit.".to_string());
    let unsure = summary.answer.unresolved().len();
    if unsure > 0 {
        rest.push(format!(
            "This mesh does not resolve {unsure} of {} certified figures: they are named below.",
            summary.answer.certificate.len()
        ));
    }
    let (grade, head) = match (missed.is_empty(), flows) {
        (false, None) => (Grade::Bad, "Solved; the sizing rules are not met."),
        (false, Some(_)) => (
            Grade::Bad,
            "Solved; the sizing rules are not met, and steel yields.",
        ),
        (true, Some(_)) => (Grade::Care, "Solved; steel yields."),
        (true, None) if unsure > 0 => (Grade::Care, "Solved; not all figures are resolved."),
        (true, None) => (Grade::Good, "Solved."),
    };
    Verdict { grade, head, rest }
}

/// The sizing rules that have a limit here, as the beginning of a sentence; `None` where nothing can yield.
fn judged_rules(summary: &Summary) -> Option<&'static str> {
    let sizing = summary.sizing.as_ref()?;
    if sizing.rule.is_some() {
        return Some("The sizing rules (2-49) to (2-51) are");
    }
    let has_limit = sizing.lines.iter().any(|line| line.met.is_some());
    has_limit.then_some("The pressure limit (2-49) is")
}

/// The sizing rules that are missed, in words.
pub fn missed_rules(summary: &Summary) -> Vec<String> {
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut missed = Vec::new();
    let lines = sizing.lines.iter().filter(|line| line.met == Some(false));
    let most = |share: &Option<f64>| share.unwrap_or(0.0);
    let worst = lines
        .clone()
        .max_by(|a, b| most(&a.utilisation).total_cmp(&most(&b.utilisation)));
    if let Some(line) = worst {
        let (count, of) = (lines.count(), sizing.lines.len());
        missed.push(format!(
            "{count} of {of} lines of contact press beyond 1.65 times yield, (2-49), most of all {} at {} of the limit",
            line.interface,
            share(line.utilisation)
        ));
    }
    if let Some(rule) = &sizing.rule {
        for (name, demand) in [("printed", rule.printed), ("exact", rule.exact)] {
            if !demand.met {
                let used = demand.required_diameter_times_length / demand.provided;
                missed.push(format!(
                    "D L is short by the {name} constant, (2-50): {} of what there is",
                    share(Some(used))
                ));
            }
        }
    }
    missed
}
