//! How far a target is sought, how that ended, and where the levels write.

use super::level::{Level, RefinedFigure};
use crate::product::job::Options;
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
        "no mesh meets it: {} of {} lies at a loaded edge, where the elastic stress is \
         singular; it went {}",
        figure.what.name(),
        figure.place,
        values.join(", ")
    ))
}
