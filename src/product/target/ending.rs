//! How far a target is sought, how that ended, and where the levels write.

use super::level::{Level, RefinedFigure};
use crate::product::converge::ConvergeError;
use crate::product::job::{self, JobError, Options, Outcome};
use std::path::{Path, PathBuf};

/// How far to go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TargetLimits {
    /// Levels to solve at most.
    pub levels: usize,
    /// A level that is expected to have more unknowns is not solved.
    pub unknowns: f64,
}

impl Default for TargetLimits {
    fn default() -> Self {
        Self {
            levels: 8,
            unknowns: 1.5e6,
        }
    }
}

/// How it ended.
#[derive(Debug, Clone, PartialEq)]
pub enum TargetVerdict {
    Met,
    /// Why it was not.
    NotMet(String),
    Interrupted,
}

/// What was solved on the way to a target.
#[derive(Default)]
pub(super) struct Known {
    pub(super) levels: Vec<Level>,
    /// Of the last of them that is of the case itself.
    pub(super) last: Option<Outcome>,
}

/// The verdict on a target, and the outcome that it is about.
pub(super) type Ended = Result<(TargetVerdict, Outcome), ConvergeError>;

/// Levels whose peak has no estimate before that is believed.
const SINGULAR_LEVELS: usize = 3;

/// The folder of all levels, and the options of level `number`.
pub(super) fn places(options: &Options, number: usize) -> (PathBuf, Options) {
    let below = options.out.as_deref().unwrap_or(Path::new("."));
    let own = Options {
        out: options.out.as_deref().map(|out| folder(out, number)),
        ..options.clone()
    };
    (below.to_owned(), own)
}

/// Name of the folder of level `number`.
pub(super) fn name(number: usize) -> String {
    format!("level-{number}")
}

/// Where level `number` writes.
pub fn folder(below: &Path, number: usize) -> PathBuf {
    below.join(name(number))
}

/// The level that an outcome is of.
pub fn last_level(levels: &[Level], verdict: &TargetVerdict) -> usize {
    // One that was interrupted is not told of.
    let told = usize::from(*verdict != TargetVerdict::Interrupted);
    levels.len().saturating_sub(told)
}

/// Removes what earlier runs left in the folder of all levels and in those of levels beyond `last`: nothing there could be
/// taken for the answer.
pub(super) fn clear_beyond(out: &Path, last: usize) -> Result<(), JobError> {
    job::clear(out, false)?;
    let beyond = (last + 1..).map(|number| folder(out, number));
    (beyond.take_while(|folder| folder.is_dir())).try_for_each(|folder| job::clear(&folder, false))
}

/// Why no mesh meets a target, where that is plain: finer meshes resolve all but peaks beside edges.
pub(super) fn singular(levels: &[Level]) -> Option<String> {
    let singular =
        |f: &RefinedFigure| f.at_edge && f.estimate.is_none() && f.what.away_from_edges().is_some();
    let unknown = |level: &Level| level.figures.iter().any(singular);
    if levels.len() < SINGULAR_LEVELS || !levels.iter().rev().take(SINGULAR_LEVELS).all(unknown) {
        return None;
    }
    let figure = levels.last()?.figures.iter().find(|f| singular(f))?;
    let values: Vec<String> = levels
        .iter()
        .filter_map(|l| l.value_of(figure.goal))
        .map(|v| format!("{v:.4}"))
        .collect();
    Some(format!(
        "no mesh meets it: {} of {} lies at a singular edge, where the elastic stress is \
         singular; it went {}",
        figure.what.name(),
        figure.place,
        values.join(", ")
    ))
}
