//! One case on a series of meshes: error against unknowns, run time and memory.
//!
//! A [`MeshSeries`] says which meshes; [`run`] solves the case on one of them and reads its
//! quantities and its cost; [`Study`] gathers the levels; [`rates`] says how fast they approach
//! which reference. [`table`], [`json`], [`plot`] and [`page`] put it out.

pub mod contact_profile;
pub mod cost;
pub mod energy;
mod error;
pub mod json;
pub mod page;
pub mod peers;
pub mod plot;
pub mod problem_h;
mod quantity;
pub mod rates;
mod read;
pub mod series;
pub mod study;
pub mod table;

pub use error::{ConvergeError, Missing};
pub use quantity::{Known, StudyQuantity};
pub use series::MeshSeries;
pub use study::{Curve, Reference, Study, StudyLevel};

use crate::case::Case;
use crate::model::scene::ElementKind;
use crate::product::job::{self, Options};
use crate::solver::solve::Observer;
use cost::Meter;
use std::path::Path;
use std::time::Instant;

/// A level and what was read from it, or `None` where the observer stopped the run.
pub type SolvedLevel = Option<(StudyLevel, Vec<StudyQuantity>)>;

/// Solves `case` on level `level` of `series` with `element`. A mesh that gmsh makes is kept
/// below `out`. The cost is that of building the scene, solving it and reading its quantities; the
/// mesh is made before.
///
/// # Errors
/// [`ConvergeError`], where there is no such mesh or the solver does not converge on it.
pub fn run(
    case: &Case,
    series: &MeshSeries,
    level: usize,
    element: ElementKind,
    out: &Path,
    observer: &mut dyn Observer,
) -> Result<SolvedLevel, ConvergeError> {
    let (mut case, mesh) = series.mesh(case, level, out, observer)?;
    case.set_element(element);
    let name = mesh.source.clone();
    let options = Options {
        out: None,
        ..Options::default()
    };
    let meter = Meter::start();
    let outcome = job::run_on(&case, mesh, &options, Instant::now(), observer)?;
    if outcome.interrupted {
        return Ok(None);
    }
    let quantities = read::read(&case, &outcome)?;
    let cost = meter.stop();
    let counters = &outcome.solution.counters;
    let level = StudyLevel {
        level,
        element: study::element_name(element),
        mesh: name,
        size: series.size(level, outcome.scene.mesh.hexes.len()),
        elements: outcome.scene.mesh.hexes.len(),
        dofs: counters.equations,
        iterations: counters.iterations,
        factorisations: counters.factorisations,
        cost,
        values: quantities.iter().map(|q| q.value).collect(),
    };
    Ok(Some((level, quantities)))
}

#[cfg(test)]
mod sample;
