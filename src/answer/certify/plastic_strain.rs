//! The peak plastic strain, known as well as what the stress exceeds yield by.

use super::figure::{Errors, Figure, Quantity, figure_of};
use crate::answer::results::peaks::BodyPeaks;

const UNCERTAIN_FLOW: &str =
    "the elastic peak is as uncertain as its excess over yield: it may be zero";

const NO_ELASTIC_PEAK: &str = "no elastic solution beside it says by how much the stress exceeds yield, and with it how well the strain is known";

/// The peak plastic strain. Near its beginning it is what the elastic stress exceeds the yield limit
/// by, over the stiffness: it is known as well as that excess is.
pub(super) fn plastic_strain(body: &BodyPeaks, elastic: Option<&Figure>) -> Figure {
    let value = body.peeq_max;
    let spread = (value - body.peeq_mean) / value;
    let excess = elastic.map(|peak| {
        // What has yielded stands at its limit, or a little above.
        let limit = body
            .centroid
            .map_or(0.0, |p| p.value)
            .max(body.nodal.map_or(0.0, |p| p.value));
        let excess = (peak.value - limit).max(0.0);
        peak.error.of_mesh().map(|error| error / excess)
    });
    let note = excess.map_or(NO_ELASTIC_PEAK, |_| UNCERTAIN_FLOW);
    let share = excess.flatten().map(|share| share.max(spread));
    let share = share.filter(|share| *share <= 1.0);
    Figure {
        error: Errors {
            discretisation: share.map(|share| share * value),
            ..Errors::default()
        },
        note: share.is_none().then_some(note),
        ..figure_of(Quantity::PeakPlasticStrain, &body.name, value)
    }
}
