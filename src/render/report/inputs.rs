//! What the page is made from.

use super::calculation::Calculation;
use super::history::Iterate;
use crate::answer::pictures::Pictures;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::summary::Summary;

/// Name of the page in the folder of a run.
pub const FILE: &str = "report.html";

/// What the page is made from.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    pub summary: &'a Summary,
    pub scene: &'a Scene,
    /// The state that the summary describes, and the fields recovered from it.
    pub state: &'a State,
    pub recovered: &'a Recovered,
    pub pictures: &'a Pictures,
    /// What is known of the calculation beside its answer.
    pub calculation: &'a Calculation,
    /// The iterations of this run, in their order.
    pub history: &'a [Iterate],
    /// Limits of the checks that the answer misses, in words.
    pub missed: &'a [String],
    /// Path and text of the case file.
    pub case: (&'a str, &'a str),
    /// What else a reader needs to repeat the run: name and value.
    pub setting: &'a [(String, String)],
}
