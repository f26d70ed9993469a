//! Peak stress and strain of bodies.

use super::{Claim, Errors, Evidence, Quantity};
use crate::results::edges::LoadedEdges;
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
/// element, while a centre lies close to it (problem H, h/a = 1/4 to 1/32: nodal 3 to 0.03 % high,
/// centroid within 0.5 to 0.02 %). Their difference is the estimate.
pub(super) fn claims(evidence: &Evidence, own: &[BodyPeaks]) -> Vec<Claim> {
    let Evidence {
        scene,
        state,
        elastic,
        ..
    } = *evidence;
    let edges = LoadedEdges::find(scene, state);
    let singular = |peak: &Peak| edges.touches(&scene.mesh, state, peak);
    let mut claims = Vec::new();
    for (index, body) in own.iter().enumerate() {
        let yielded = body.peeq_max > 0.0;
        let mut mises = peak(Quantity::PeakMises, body, singular);
        if let Some(claim) = mises.as_mut().filter(|_| yielded) {
            claim.note = Some(YIELDED);
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
        let elastic = elastic.and_then(|bodies| bodies.get(index));
        claims.extend(elastic.and_then(|body| peak(Quantity::ElasticPeakMises, body, singular)));
    }
    claims
}

/// The nodal peak of a body. Beside a loaded edge no error can be given.
fn peak(what: Quantity, body: &BodyPeaks, singular: impl Fn(&Peak) -> bool) -> Option<Claim> {
    let (nodal, centroid) = (body.nodal?, body.centroid?);
    let singular = singular(&nodal);
    let spread = (nodal.value - centroid.value).abs();
    Some(Claim {
        what,
        place: body.name.clone(),
        value: nodal.value,
        error: Errors {
            discretisation: (!singular).then_some(spread),
            ..Errors::default()
        },
        note: singular.then_some(SINGULAR),
    })
}
