//! The verdict on a design, from what was found at each position.

use super::advice::Advice;
use super::position::Placed;
use super::standing::SizeStanding;
use crate::ground::units::UnitLabels;
use crate::product::size::candidate::Candidate;
use crate::product::size::error::SizeError;
use crate::product::size::proposal::Proposal;
use serde::Serialize;

/// The verdict on a design.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DesignVerdict {
    /// Is no limit missed, and everything resolved that is held against one?
    pub met: bool,
    /// Limits of which the mesh cannot tell.
    pub open: usize,
    pub units: UnitLabels,
    pub brinell_version: &'static str,
    pub load: f64,
    pub yield_stress: f64,
    pub capacity: f64,
    pub mesh: String,
    pub design: Candidate,
    pub positions: Vec<Placed>,
    /// What would help, where a limit is missed.
    pub advice: Option<Advice>,
}

impl DesignVerdict {
    /// The verdict on `design` from what was found at each position.
    ///
    /// # Errors
    /// Where a remedy cannot be sized.
    pub fn new(
        proposal: &Proposal,
        design: &Candidate,
        positions: Vec<Placed>,
    ) -> Result<Self, SizeError> {
        let request = &proposal.request;
        let met = positions.iter().all(Placed::met);
        let advice = if positions.iter().any(Placed::misses) {
            Some(Advice::new(request, &positions)?)
        } else {
            None
        };
        let checks = positions.iter().flat_map(|p| &p.checks);
        Ok(Self {
            met,
            open: checks.filter(|c| c.standing == SizeStanding::Open).count(),
            units: proposal.units.clone(),
            brinell_version: env!("CARGO_PKG_VERSION"),
            load: request.load,
            yield_stress: request.yield_stress,
            capacity: request.capacity,
            mesh: request.preset.value.name().to_string(),
            design: design.clone(),
            positions,
            advice,
        })
    }
}
