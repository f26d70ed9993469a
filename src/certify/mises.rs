//! Peak stress and strain of bodies.

use super::{Claim, Errors, Quantity};
use crate::results::peaks::{BodyPeaks, Peak};

const YIELDED: &str = "yielded: the Mises stress is held by the yield limit and says nothing of the \
                       mesh; look at the elastic peak and the plastic strain";

const SINGULAR: &str = "at a loaded edge: singular in elasticity, grows with every refinement until \
                        the steel yields";

/// Peak Mises stress of every body; where it has yielded also its peak plastic strain and the peak
/// of the elastic solution.
///
/// The nodal peak is claimed. It and that of element centres tend to the same value from different
/// sides of the error: extrapolation to nodes overshoots by the curvature of the stress over an
/// element, while a centre lies close to it. Their difference is the estimate. Beside a loaded edge
/// there is none, and the peak away from such edges is claimed, too.
pub(super) fn claims(own: &[BodyPeaks], elastic: Option<&[BodyPeaks]>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (index, body) in own.iter().enumerate() {
        let yielded = body.peeq_max > 0.0;
        let mut mises = mises(body, [Quantity::PeakMises, Quantity::MisesAway]);
        if yielded {
            mises
                .iter_mut()
                .for_each(|claim| claim.note = Some(YIELDED));
        }
        claims.extend(mises);
        if !yielded {
            continue;
        }
        claims.push(Claim {
            what: Quantity::PeakPlasticStrain,
            place: body.name.clone(),
            value: body.peeq_max,
            error: Errors {
                discretisation: Some(body.peeq_max - body.peeq_mean),
                ..Errors::default()
            },
            note: None,
        });
        if let Some(elastic) = elastic.and_then(|bodies| bodies.get(index)) {
            let names = [Quantity::ElasticPeakMises, Quantity::ElasticMisesAway];
            claims.extend(self::mises(elastic, names));
        }
    }
    claims
}

/// The nodal peak of a body, and that away from loaded edges where it lies at one.
fn mises(body: &BodyPeaks, [peak, away]: [Quantity; 2]) -> Vec<Claim> {
    let claim = |what: Quantity, [nodal, centroid]: [Peak; 2]| Claim {
        what,
        place: body.name.clone(),
        value: nodal.value,
        error: Errors {
            discretisation: Some((nodal.value - centroid.value).abs()),
            ..Errors::default()
        },
        note: None,
    };
    let Some(pair) = body.nodal.zip(body.centroid) else {
        return Vec::new();
    };
    let mut claims = vec![claim(peak, pair.into())];
    if let Some(regular) = body.away {
        claims[0].error.discretisation = None;
        claims[0].note = Some(SINGULAR);
        claims.push(claim(away, regular));
    }
    claims
}
