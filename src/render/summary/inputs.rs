//! What a summary is made from.

use super::checks::Checks;
use super::values::{Comparison, Counters, Timing};
use crate::answer::certify::Claim;
use crate::answer::results::bore::Bore;
use crate::answer::results::line_load::Slices;
use crate::answer::results::peaks::BodyPeaks;
use crate::answer::results::recovery::Recovered;
use crate::answer::results::strip::Strip;
use crate::model::scene::Scene;
use crate::model::state::State;
use crate::render::left_out::LeftOut;
use crate::render::units::UnitLabels;

/// What a summary is made from. Figures are in the units of the scene, which `units` names.
#[derive(Debug, Clone)]
pub struct SummaryInputs<'a> {
    pub case: &'a str,
    pub units: UnitLabels,
    pub scene: &'a Scene,
    /// The state to report: the end of the last step, or of the last before unloading.
    pub state: &'a State,
    /// The state after unloading, where there is one.
    pub unloaded: Option<&'a State>,
    /// Displacement of every node that stays when what is left of the load is taken off
    /// elastically; without it dents have the pressing of that load in them.
    pub stays: Option<&'a [[f64; 3]]>,
    /// The states at the ends of the steps, as far as they are done.
    pub steps: &'a [State],
    pub recovered: &'a Recovered,
    /// Peaks of the elastic solution at the same load, in the order of the bodies.
    pub elastic: Option<&'a [BodyPeaks]>,
    /// The claims of the solution in increments twice as large.
    pub doubled: Option<&'a [Claim]>,
    pub converged: bool,
    pub counters: Counters,
    pub timing: Timing,
    pub peak_memory_bytes: Option<u64>,
    /// What to measure at each interface, in the order of the pairs; line load in ten equal
    /// slices where the list is shorter.
    pub measures: &'a [Measure],
    pub bores: &'a [Bore],
    /// Checks made elsewhere; a force balance, penetration or Coulomb violation that is left out
    /// is computed here.
    pub checks: Checks,
    pub comparison: &'a [Comparison],
    pub assumptions: &'a [String],
    pub left_out: &'a [LeftOut],
}

/// What to measure at an interface beyond its scalars.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Measure {
    /// Slices of the line load.
    pub slices: Option<Slices>,
    /// The strip whose half-width is wanted.
    pub strip: Option<Strip>,
}
