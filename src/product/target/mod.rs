//! Refining until a figure is as good as asked for.
//!
//! The case is solved on finer and finer meshes of its series until the certificate's estimate is within the target, or
//! until it is plain that it will not be. Of a bearing on meshes that are sized by its lines of contact the bars decide,
//! and choose the next mesh: that they hold is what the coverage suite asks. Of other scenes the change from the mesh
//! before must be as small.

mod by_bars;
mod ending;
mod goal;
mod level;
mod local;
mod plan;

pub use ending::{TargetLimits, TargetVerdict, folder, last_level};
pub use goal::{Goal, Target, TargetError};
pub use level::{Level, RefinedFigure, table};

use crate::case::Case;
use crate::model::mesh::Mesh;
use crate::product::converge::cost::Meter;
use crate::product::converge::{ConvergeError, MeshSeries};
use crate::product::job::{self, Options, Outcome};
use crate::solver::solve::Observer;
use ending::{Ended, Known, clear_beyond, places, singular};
use std::f64::consts::SQRT_2;
use std::time::Instant;

/// Solves `case` level by level. A bearing that is meshed by its lines of contact has the next mesh that its bars ask for.
/// Other meshes of a bearing are halved at the contact, and all their elements smaller by √2 from one to the next. Other
/// cases as in [`MeshSeries`].
///
/// Each is solved in a folder `level-<n>` of its own below that of `options`;
/// `told` hears of every level. The outcome is that of the last one. Where a finer mesh cannot be made or solved, the one
/// before it stands.
///
/// # Errors
/// Where the first mesh cannot be made or the solver does not converge on it.
pub fn refine(
    case: &Case,
    target: &Target,
    limits: &TargetLimits,
    options: &Options,
    observer: &mut dyn Observer,
    mut told: impl FnMut(&Level),
) -> Result<(Vec<Level>, TargetVerdict, Outcome), ConvergeError> {
    let _folder = options.open()?;
    let mut known = Known::default();
    let asked = (target, limits);
    let ended = match job::is_sized_by_lines(case) {
        true => by_bars::refine(case, asked, options, observer, (&mut known, &mut told)),
        false => by_changes(case, asked, options, observer, (&mut known, &mut told)),
    };
    let Known { levels, last } = known;
    let (verdict, outcome) = match (ended, last) {
        (Err(error), Some(outcome)) if error.is_of_mesh() => {
            let count = levels.len();
            let why = format!(
                "not met by the finest of {count} meshes, and there is no finer one: {error}"
            );
            (TargetVerdict::NotMet(why), outcome)
        }
        (ended, _) => ended?,
    };
    if let Some(out) = &options.out {
        clear_beyond(out, last_level(&levels, &verdict))?;
    }
    Ok((levels, verdict, outcome))
}

/// Refines mesh by mesh until bars and changes are small.
fn by_changes(
    case: &Case,
    (target, limits): (&Target, &TargetLimits),
    options: &Options,
    observer: &mut dyn Observer,
    (known, told): (&mut Known, &mut dyn FnMut(&Level)),
) -> Ended {
    let Known { levels, last } = known;
    let mut series = MeshSeries::of(case, &[], SQRT_2)?;
    if let MeshSeries::Template { contact, .. } = &mut series {
        *contact = SQRT_2;
    }
    // Of a mesh that is refined where it has to be: the one of the level to come.
    let mut refined: Option<Mesh> = None;
    loop {
        let number = levels.len();
        let (below, own) = places(options, number);
        let meter = Meter::start();
        let (scaled, mesh) = match refined.take() {
            Some(mesh) => (case.clone(), mesh),
            None => series.mesh(case, number, &below, observer)?,
        };
        let coarse = (series == MeshSeries::Split).then(|| mesh.clone());
        let outcome = job::run_on(&scaled, mesh, &own, Instant::now(), observer)?;
        if outcome.interrupted {
            return Ok((TargetVerdict::Interrupted, outcome));
        }
        let asked = (target, false);
        let level = Level::new(number, asked, &outcome.summary, levels.last(), meter.stop());
        told(&level);
        levels.push(level);
        if let Some(verdict) = judge(levels, target, limits) {
            return Ok((verdict, outcome));
        }
        let outcome = last.insert(outcome);
        if let (Some(coarse), Some(level)) = (coarse, levels.last()) {
            refined = Some(finer(&coarse, level, target, outcome)?);
        }
    }
}

/// The mesh split where the figures that miss the target ask for it; throughout, where nothing says where.
fn finer(
    mesh: &Mesh,
    level: &Level,
    target: &Target,
    outcome: &Outcome,
) -> Result<Mesh, ConvergeError> {
    let solved = (&outcome.scene, outcome.state());
    Ok(match local::marks(solved, level, target) {
        Some(marks) => mesh.split_some(|element| marks[element])?.mesh,
        None => mesh.split()?,
    })
}

/// The verdict after these levels; `None` while there is more to do.
fn judge(levels: &[Level], target: &Target, limits: &TargetLimits) -> Option<TargetVerdict> {
    let last = levels.last()?;
    if last.figures.is_empty() {
        return Some(TargetVerdict::NotMet(target.goal.has_no_claim()));
    }
    if last.meets(target) {
        return Some(TargetVerdict::Met);
    }
    if let Some(why) = singular(levels) {
        return Some(TargetVerdict::NotMet(why));
    }
    let next = last.unknowns as f64 * growth(levels);
    if levels.len() >= limits.levels || next > limits.unknowns {
        let why = format!(
            "not met by the finest of {} meshes; the next one would have about {next:.0} unknowns",
            levels.len(),
        );
        return Some(TargetVerdict::NotMet(why));
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
