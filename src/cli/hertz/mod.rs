//! `brinell hertz`: the handbook and the design rules at the command line.

mod arguments;
mod error;
mod question;
mod table;

use serde::Serialize;

pub use arguments::HertzArgs;
pub use error::HertzError;

use crate::analytic::handbook::{Handbook, HandbookAnswer, handbook};
use crate::analytic::rules::{LoadError, RuleInput, rules};
use crate::ground::units::UnitLabels;
use crate::render::summary::{JudgedRule, RuleSheet};
use question::question;

/// Question and answer, as JSON.
#[derive(Serialize)]
struct Sheet<'a> {
    units: &'static str,
    input: &'a Handbook,
    answer: &'a HandbookAnswer,
    rules: &'a [JudgedRule],
}

/// The answer to the arguments as the text to print: a table, or JSON.
///
/// # Errors
/// [`HertzError`] for an argument that is no quantity, or outside its range.
pub fn answer(args: &HertzArgs) -> Result<String, HertzError> {
    let question = question(args)?;
    let answer = handbook(&question.handbook)?;
    let rules = judged(&question.rules, &answer)?;
    if args.json {
        let sheet = Sheet {
            units: question.units.name(),
            input: &question.handbook,
            answer: &answer,
            rules: &rules.rules,
        };
        // Numbers, words and lists: nothing in the sheet can fail to serialize.
        return Ok(serde_json::to_string_pretty(&sheet).unwrap_or_default());
    }
    Ok(table::table(
        &UnitLabels::of(question.units),
        &answer,
        &rules,
    ))
}

/// Every rule under the even load, and, off the centre, over the length that bears and under the largest of a linear
/// load.
fn judged(input: &RuleInput, answer: &HandbookAnswer) -> Result<RuleSheet, HertzError> {
    let displaced = answer.displaced.as_ref();
    let even = displaced.map_or(answer.line_load, |d| d.block.line_load);
    let largest = displaced.map(|d| d.linear.line_load);
    let rules = rules(input)?.into_iter().map(|rule| JudgedRule {
        even: rule.judge(even, LoadError::None),
        largest: largest.and_then(|load| rule.judge(load, LoadError::None)),
        even_line: None,
        largest_line: None,
        rule,
    });
    let hollow = answer
        .bore
        .map(|_| "the rules are of solid rollers, this one is hollow".to_owned());
    Ok(RuleSheet {
        rules: rules.collect(),
        steel: Vec::new(),
        notes: hollow.into_iter().collect(),
    })
}

/// Prints the answer to standard output.
///
/// # Errors
/// As [`answer`].
pub fn run(args: &HertzArgs) -> Result<(), HertzError> {
    crate::cli::output::say(answer(args)?.trim_end());
    Ok(())
}

#[cfg(test)]
mod tests;
