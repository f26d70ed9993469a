//! Making the true values of a bearing.

use super::bearing::Bearing;
use super::fine;
use super::pair::MeshPair;
use super::solution::{self, Keep, SolvedBearing};
use crate::product::job::JobError;
use crate::solver::solve::Observer;

/// Solves `bearing` on its two fine meshes.
///
/// # Errors
/// [`JobError`].
pub fn make(
    bearing: &Bearing,
    elastic: bool,
    keep: &Keep,
    observer: &mut dyn Observer,
) -> Result<MeshPair, JobError> {
    let twin = bearing.twin()?;
    let own = bearing.case()?;
    let name = |mesh: &str, elastic: bool| {
        let steel = if elastic { "elastic" } else { "own" };
        format!("{}/{mesh}-{steel}", bearing.name)
    };
    let mut coarse = twin.clone();
    coarse.set_preset("h025")?;
    let coarse = solution::solve(&coarse, (keep, &name("h025", true)), false, observer)?;
    let case = if elastic { &twin } else { &own };
    let mut solved = Vec::new();
    for (scale, case) in fine::cases(case, &coarse)? {
        let name = name(&format!("fine-{scale}"), elastic);
        solved.push(solution::solve(&case, (keep, &name), false, observer)?);
    }
    match <[SolvedBearing; 2]>::try_from(solved) {
        Ok(pair) => Ok(MeshPair::new(&pair)),
        Err(_) => Err(JobError::Interrupted),
    }
}
