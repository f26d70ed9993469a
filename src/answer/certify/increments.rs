//! What the size of the increments does to figures: plastic flow and friction are integrated along the path.

use super::figure::{Figure, Quantity, figure};

/// The error of the increments, over the difference that doubling them makes. It would be one where the error
/// of an increment grows with the square of its size and flow is smooth; corners begin to flow one by one.
pub const DOUBLING: f64 = 1.5;

/// Said of a figure whose bar does not know of it.
pub const WITHOUT_INCREMENTS: &str =
    "the bar is without what the increments did: there is no second solution to tell";

/// What an answer remembers of its path.
pub(super) struct Memory<'a> {
    pub flows: bool,
    pub rubs: bool,
    /// Is the elastic solution of another mesh? Then its claims know their own errors.
    pub elastic_elsewhere: bool,
    /// The claims of the solution in increments twice as large.
    pub doubled: Option<&'a [Figure]>,
}

impl Memory<'_> {
    /// What the size of the increments does to a figure, from the same figure in increments twice as large: nothing
    /// where nothing yields or rubs; `None` where there is no such figure.
    ///
    /// Friction remembers even where loads only grow together: p_max of six displaced and centred bearings moved by
    /// 1e-5 to 3e-3, their peak Mises stress by up to 1e-2, when increments became six to twelve times smaller.
    pub(super) fn error(&self, claim: &Figure) -> Option<f64> {
        let elastic = matches!(
            claim.what,
            Quantity::ElasticPeakMises | Quantity::ElasticMisesAway
        );
        if elastic && self.elastic_elsewhere {
            return claim.error.increment;
        }
        if !self.rubs && (elastic || !self.flows) {
            return Some(0.0);
        }
        let other = figure(self.doubled?, claim.what, &claim.place)?;
        Some(DOUBLING * (claim.value - other.value).abs())
    }
}
