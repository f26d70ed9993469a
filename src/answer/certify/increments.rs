//! What the size of the increments does to figures: plastic flow and friction are integrated along the path.

use super::figure::{Figure, Quantity, figure};

/// The error of the increments, over the difference that doubling them makes. It would be one where the error
/// of an increment grows with the square of its size and flow is smooth; corners begin to flow one by one.
pub const DOUBLING: f64 = 1.5;

/// What the size of the increments does to a figure, from the same figure in increments twice as large.
pub(super) fn error(claim: &Figure, doubled: Option<&[Figure]>) -> Option<f64> {
    match claim.what {
        // Of another solution, which only friction ties to its path.
        Quantity::ElasticPeakMises | Quantity::ElasticMisesAway => None,
        what => {
            let other = figure(doubled?, what, &claim.place)?;
            Some(DOUBLING * (claim.value - other.value).abs())
        }
    }
}
