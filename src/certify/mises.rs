//! Peak stress and strain of bodies.

use super::{Claim, Errors, Quantity, claim_of};
use crate::results::peaks::{BodyPeaks, Peak};

const YIELDED: &str = "yielded: the Mises stress is held by the yield limit and says nothing of the \
                       mesh; look at the elastic peak and the plastic strain";

const SINGULAR: &str = "at a loaded edge: singular in elasticity, grows with every refinement until \
                        the steel yields";

const UNCERTAIN_FLOW: &str = "the error of the elastic peak is as large as what it exceeds the yield limit by: \
                              the plastic strain may be zero";

/// Share of the distance between the largest value at an integration point and the nodal one.
const OVERSHOOT: f64 = 0.5;

/// Peak Mises stress of every body; where it has yielded also its peak plastic strain and the peak
/// of the elastic solution.
///
/// The nodal peak is claimed. It and that of element centres tend to the same value from different
/// sides of the error: extrapolation to nodes overshoots by the curvature of the stress over an
/// element, while a centre lies close to it; the largest value at an integration point overshoots
/// most. Their differences are the estimate. Beside a loaded edge there is none, and the peak away
/// from such edges is claimed, too.
pub(super) fn claims(own: &[BodyPeaks], elastic: Option<&[BodyPeaks]>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, body) in own.iter().enumerate() {
        let yielded = body.peeq_max > 0.0;
        let mut peaks = mises(body, [Quantity::PeakMises, Quantity::MisesAway]);
        if !yielded {
            claims.extend(peaks);
            continue;
        }
        peaks
            .iter_mut()
            .for_each(|claim| claim.note = Some(YIELDED));
        claims.extend(peaks);
        let names = [Quantity::ElasticPeakMises, Quantity::ElasticMisesAway];
        let elastic = elastic.and_then(|bodies| bodies.get(index));
        let elastic = elastic.map_or_else(Vec::new, |elastic| mises(elastic, names));
        claims.push(plastic_strain(body, elastic.first()));
        claims.extend(elastic);
    }
    claims
}

/// The peak plastic strain. Near its beginning it is what the elastic stress exceeds the yield limit
/// by, over the stiffness: it is known as well as that excess is.
fn plastic_strain(body: &BodyPeaks, elastic: Option<&Claim>) -> Claim {
    let value = body.peeq_max;
    let spread = (value - body.peeq_mean) / value;
    let excess = elastic.map(|peak| {
        // What has yielded stands at its limit, or a little above.
        let limit = body
            .centroid
            .map_or(0.0, |p| p.value)
            .max(body.nodal.map_or(0.0, |p| p.value));
        let excess = (peak.value - limit).max(0.0);
        peak.error.discretisation.map(|error| error / excess)
    });
    let share = match excess {
        None => Some(spread),
        Some(share) => share.map(|share| share.max(spread)),
    };
    let share = share.filter(|share| *share <= 1.0);
    Claim {
        error: Errors {
            discretisation: share.map(|share| share * value),
            ..Errors::default()
        },
        note: share.is_none().then_some(UNCERTAIN_FLOW),
        ..claim_of(Quantity::PeakPlasticStrain, &body.name, value)
    }
}

/// The nodal peak of a body, and that away from loaded edges where it lies at one.
fn mises(body: &BodyPeaks, [peak, away]: [Quantity; 2]) -> Vec<Claim> {
    let Some([nodal, centroid]) = body.nodal.zip(body.centroid).map(<[Peak; 2]>::from) else {
        return Vec::new();
    };
    let claim = |what: Quantity, [nodal, centroid]: [Peak; 2], overshoot: f64| {
        let spread = (nodal.value - centroid.value).abs();
        Claim {
            error: Errors {
                discretisation: Some(spread.max(OVERSHOOT * overshoot)),
                ..Errors::default()
            },
            ..claim_of(what, &body.name, nodal.value)
        }
    };
    let overshoot = body
        .integration_point
        .map_or(0.0, |p| (p.value - nodal.value).abs());
    match body.away {
        None => vec![claim(peak, [nodal, centroid], overshoot)],
        Some(regular) => {
            let singular = Claim {
                note: Some(SINGULAR),
                ..claim_of(peak, &body.name, nodal.value)
            };
            vec![singular, claim(away, regular, 0.0)]
        }
    }
}
