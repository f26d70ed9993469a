//! What solving a scene will take, reckoned from its first model without making it.

use super::error::SolveError;
use super::foresight::Expected;
use super::model::needed;
use super::rows::contact_rows;
use super::size::{is_large, memory};
use super::start;
use crate::fem::dofs::DofMap;
use crate::scene::{Scene, SolverKind};

/// Unknowns and bytes of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    pub unknowns: usize,
    pub memory: f64,
}

/// Reckons what solving `scene` will take. Floating bodies are moved into touch first, as a solution
/// does.
///
/// # Errors
/// [`SolveError`] where supports contradict each other or nothing is free.
pub fn estimate(scene: &mut Scene) -> Result<Estimate, SolveError> {
    start::close_gaps(scene, 1e-10 * start::extent(scene));
    let dofs = DofMap::new(scene)?;
    if dofs.is_empty() {
        return Err(SolveError::NothingFree);
    }
    let expected = Expected {
        reach: start::reach(scene),
        contact: start::likely_gap(scene),
        flow: Vec::new(),
        divided: false,
    };
    let (rows, _) = expected.split(contact_rows(scene, expected.reach));
    let needed = needed(scene, &dofs, &rows, &[]);
    let divided = match scene.controls.solver {
        SolverKind::Auto => is_large(scene, &dofs, &needed),
        SolverKind::Direct => false,
        SolverKind::Divided => true,
    };
    Ok(Estimate {
        unknowns: dofs.len(),
        memory: memory(scene, &dofs, &needed, divided),
    })
}
