//! Refining until a figure is as good as asked for.
//!
//! The case is solved on finer and finer meshes of its series until the certificate's estimate is within the target, or
//! until it is plain that it will not be. Of a bearing on meshes that are sized by its lines of contact the bars decide:
//! that they hold is what the coverage suite asks. Of other scenes the change from the mesh before must be as small.

mod goal;
mod level;

pub use goal::{Goal, Target, TargetError};
pub use level::{Figure, Level, table};

use crate::case::Case;
use crate::product::converge::cost::Meter;
use crate::product::converge::{ConvergeError, Series};
use crate::product::job::{self, Options, Outcome};
use crate::solver::solve::Observer;
use std::f64::consts::SQRT_2;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How far to go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Levels to solve at most.
    pub levels: usize,
    /// A level that is expected to have more unknowns is not solved.
    pub unknowns: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            levels: 8,
            unknowns: 1.5e6,
        }
    }
}

/// How it ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    Met,
    /// Why it was not.
    NotMet(String),
    Interrupted,
}

/// Levels whose peak has no estimate before that is believed.
const SINGULAR_LEVELS: usize = 3;

/// Solves `case` level by level. A bearing that is meshed by its lines of contact begins with that mesh, made for the lines
/// as found, and all its elements are smaller by √2 from one to the next. Other meshes of a bearing are halved at the
/// contact. Other cases as in [`Series`].
///
/// Each is solved in a folder `level-<n>` of its own below that of `options`;
/// `told` hears of every level. The outcome is that of the last one.
///
/// # Errors
/// Where a mesh cannot be made or the solver does not converge on it.
pub fn refine(
    case: &Case,
    target: &Target,
    limits: &Limits,
    options: &Options,
    observer: &mut dyn Observer,
    mut told: impl FnMut(&Level),
) -> Result<(Vec<Level>, Verdict, Outcome), ConvergeError> {
    let sized_by_lines = job::is_sized_by_lines(case);
    let mut case = case.clone();
    let mut series = Series::of(&case, &[], SQRT_2)?;
    if let Series::Template { contact, .. } = &mut series
        && !sized_by_lines
    {
        *contact = SQRT_2;
    }
    let mut levels: Vec<Level> = Vec::new();
    loop {
        let number = levels.len();
        let below = options.out.as_deref().unwrap_or(Path::new("."));
        let out = folder(below, number);
        let own = Options {
            out: Some(out.clone()),
            ..options.clone()
        };
        let meter = Meter::start();
        let outcome = if sized_by_lines && number == 0 {
            let outcome = job::run(&case, &own, observer)?;
            // Finer meshes are of the lines as found.
            if let Some(strips) = job::found_strips(&out)? {
                case.set_strips(strips);
            }
            outcome
        } else {
            let (scaled, mesh) = series.mesh(&case, number, below, observer)?;
            job::run_on(&scaled, mesh, &own, Instant::now(), observer)?
        };
        if outcome.interrupted {
            return Ok((levels, Verdict::Interrupted, outcome));
        }
        let asked = (target, sized_by_lines);
        let level = Level::new(number, asked, &outcome.summary, levels.last(), meter.stop());
        told(&level);
        levels.push(level);
        if let Some(verdict) = judge(&levels, target, limits) {
            return Ok((levels, verdict, outcome));
        }
    }
}

/// Where level `number` writes.
pub fn folder(below: &Path, number: usize) -> PathBuf {
    below.join(format!("level-{number}"))
}

/// The verdict after these levels; `None` while there is more to do.
fn judge(levels: &[Level], target: &Target, limits: &Limits) -> Option<Verdict> {
    let last = levels.last()?;
    if last.figures.is_empty() {
        let why = format!("the certificate has no {}", target.goal.name());
        return Some(Verdict::NotMet(why));
    }
    if last.meets(target) {
        return Some(Verdict::Met);
    }
    // Finer meshes resolve all but peaks beside edges.
    let singular = |f: &Figure| f.estimate.is_none() && f.what.away_from_edges().is_some();
    let unknown = |level: &Level| level.figures.iter().any(singular);
    if levels.len() >= SINGULAR_LEVELS && levels.iter().rev().take(SINGULAR_LEVELS).all(unknown) {
        let figure = last.figures.iter().find(|f| singular(f))?;
        let values: Vec<String> = levels
            .iter()
            .filter_map(|l| l.value_of(figure.goal))
            .map(|v| format!("{v:.4}"))
            .collect();
        let why = format!(
            "no mesh meets it: {} of {} lies at a loaded edge, where the elastic stress is \
             singular; it went {}",
            figure.what.name(),
            figure.place,
            values.join(", ")
        );
        return Some(Verdict::NotMet(why));
    }
    let next = last.unknowns as f64 * growth(levels);
    if levels.len() >= limits.levels || next > limits.unknowns {
        let why = format!(
            "not met by the finest of {} meshes; the next one would have about {next:.0} unknowns",
            levels.len(),
        );
        return Some(Verdict::NotMet(why));
    }
    None
}

/// Unknowns of a level over those of the one before.
fn growth(levels: &[Level]) -> f64 {
    // Before two levels are known.
    const USUAL_GROWTH: f64 = 2.8;
    match levels {
        [.., a, b] => b.unknowns as f64 / a.unknowns.max(1) as f64,
        _ => USUAL_GROWTH,
    }
}
