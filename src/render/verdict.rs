//! The verdict: may the answer be used, are the sizing rules met, does steel yield.

use crate::analytic::rules::RuleVerdict;
use crate::render::figures::{share, with_error};
use crate::render::summary::{SizedLine, Summary};
use crate::render::text::significant;
use crate::render::utilisation::first_largest;

/// How good the news is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum News {
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
    pub news: News,
    /// The first sentence,
    pub head: String,
    /// and the others.
    pub rest: Vec<String>,
}

/// The verdict on a run whose checks miss the limits `missed`, in words.
pub fn verdict(summary: &Summary, missed: &[String]) -> Verdict {
    let bad = |head: &str, why| Verdict {
        news: News::Bad,
        head: head.to_owned(),
        rest: vec![why],
    };
    if !summary.answer.converged {
        let done = share(Some(summary.answer.step_done));
        let what = match summary.answer.interrupted {
            true => "The run was interrupted, and --resume goes on with it",
            false => "The solution has not converged",
        };
        let why = format!(
            "{what}: what follows is the last increment that was done, {done} of step “{}”.",
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
    let open = open_rule(summary);
    if !missed.is_empty() {
        rest.push(format!("{}.", missed.join("; ")));
    }
    if let Some(open) = &open {
        rest.push(format!("{open}."));
    } else if missed.is_empty()
        && let Some(rules) = judged_rules(summary)
    {
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
        let (standing, _) = summary.answer.standing();
        rest.push(format!(
            "This mesh does not resolve {unsure} of {} certified figures: they are named below.",
            standing.len()
        ));
    }
    let fails = fails(summary);
    let (news, head) = match (fails, flows) {
        (Some(fails), None) => (News::Bad, format!("Solved; it FAILS {fails}.")),
        (Some(fails), Some(_)) => (
            News::Bad,
            format!("Solved; it FAILS {fails}, and steel yields."),
        ),
        (None, Some(_)) => (News::Care, "Solved; steel yields.".to_owned()),
        (None, None) if open.is_some() => (
            News::Care,
            "Solved; the pressure limit (2-49) is open.".to_owned(),
        ),
        (None, None) if unsure > 0 => (
            News::Care,
            "Solved; not all figures are resolved.".to_owned(),
        ),
        (None, None) => (News::Good, "Solved.".to_owned()),
    };
    Verdict { news, head, rest }
}

/// The sizing rules that are missed, each with how much of it is used; `None` where there are none.
fn fails(summary: &Summary) -> Option<String> {
    let sizing = summary.sizing.as_ref()?;
    let lines = sizing.lines.iter().filter(|line| is_missed(line));
    let pressure = lines.filter_map(|line| line.utilisation).reduce(f64::max);
    let demands = sizing.rule.as_ref().map(|rule| [rule.printed, rule.exact]);
    let demands = demands.into_iter().flatten().filter(|demand| !demand.met);
    let used = demands.map(|demand| demand.required_diameter_times_length / demand.provided);
    let length = used.reduce(f64::max);
    let named = [
        ("the pressure limit (2-49), used to", pressure),
        ("the length rule (2-50), used to", length),
    ];
    let said = named.into_iter();
    let said = said.filter_map(|(what, used)| Some(format!("{what} {}", share(Some(used?)))));
    let said: Vec<String> = said.collect();
    (!said.is_empty()).then(|| said.join(", and "))
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

fn is_missed(line: &SizedLine) -> bool {
    line.verdict == Some(RuleVerdict::NotMet)
}

/// That (2-49) is open, where the error of p0 does not tell whether it is met, in words.
pub fn open_rule(summary: &Summary) -> Option<String> {
    let lines = &summary.sizing.as_ref()?.lines;
    let open = (lines.iter()).filter(|line| line.verdict.is_some_and(|v| v.is_within().is_none()));
    let Some(most) = first_largest(open, |line| line.utilisation.unwrap_or(0.0)) else {
        return harder_step(summary);
    };
    let used = with_error(
        100.0 * most.utilisation?,
        most.error.map(|error| 100.0 * error),
    );
    let doubt = match most.error {
        Some(_) => "",
        None => ", NOT RESOLVED",
    };
    Some(format!(
        "The pressure limit (2-49) is open: {} uses {used} % of it{doubt}",
        most.interface
    ))
}

/// That (2-49) is open, where a limit that is met is that of a step, and another one presses harder, in words.
fn harder_step(summary: &Summary) -> Option<String> {
    /// By how much, of the largest pressure.
    const HARDER: f64 = 1.01;
    let lines = &summary.sizing.as_ref()?.lines;
    if lines.iter().all(|line| line.met.is_none()) || lines.iter().any(is_missed) {
        return None;
    }
    let steps = &summary.answer.steps;
    let reported = steps.iter().find(|step| step.reported)?;
    let here = reported.max_pressure()?;
    let pressed = steps
        .iter()
        .filter_map(|step| Some((step.max_pressure()?, step)));
    let (most, step) = pressed.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (most > HARDER * here).then(|| {
        format!(
            "The pressure limit (2-49) is open: it is that of step `{}`, and step `{}` presses harder, {} against {} {}; \
             end with that step to judge it",
            reported.name,
            step.name,
            significant(most, 4),
            significant(here, 4),
            summary.units.stress
        )
    })
}

/// The sizing rules that are missed, in words.
pub fn missed_rules(summary: &Summary) -> Vec<String> {
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut missed = Vec::new();
    let lines = sizing.lines.iter().filter(|line| is_missed(line));
    let worst = first_largest(lines.clone(), |line| line.utilisation.unwrap_or(0.0));
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
