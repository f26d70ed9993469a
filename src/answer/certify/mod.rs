//! What an answer is worth: figures with their estimated errors.
//!
//! A [`Figure`] is a figure of a run and how far it may be off, by cause. The estimates come from
//! the one mesh that was solved: from the stress that a smoother field would have
//! ([`energy`]), from readings that tend to the same value (`mises`), and from how well the nodes
//! resolve the pressure (`pressure`). A bar is meant to hold in 95 of 100 cases.

pub mod energy;
mod figure;
mod increments;
mod mises;
mod other;
mod pressure;

use crate::answer::results::bore::BoreStress;
use crate::answer::results::edges::LoadedEdges;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::load::{applied, copies, descent};
use crate::answer::results::peaks::BodyPeaks;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::{ContactPair, PlaneMotion, RigidPlane, Scene};
use crate::model::state::State;
use increments::Memory;
use mises::Strip;
use pressure::Contact;
use std::f64::consts::PI;

use figure::figure_of;
pub use figure::{Errors, Figure, Quantity, figure, unresolved};
pub use increments::DOUBLING;

/// What is certified.
#[derive(Debug, Clone, Copy)]
pub struct Evidence<'a> {
    /// The solved scene.
    pub scene: &'a Scene,
    /// The state that is certified.
    pub state: &'a State,
    /// Stresses at nodes and in elements of that state.
    pub recovered: &'a Recovered,
    /// Peaks of every body and scalars of every contact pair, in their orders.
    pub peaks: &'a [BodyPeaks],
    /// Scalars of every contact pair, in their order.
    pub interfaces: &'a [Interface],
    /// The heaviest line of every pair, where it has lines.
    pub lines: &'a [Option<HeaviestLine>],
    /// Where loaded surfaces end.
    pub edges: &'a LoadedEdges,
    /// Inner walls of rollers by body.
    pub bores: &'a [(String, BoreStress)],
    /// Dents that stay: surface, its body and depth.
    pub dents: &'a [(String, String, f64)],
    /// Peaks of the elastic solution at the same load, in the order of the bodies.
    pub elastic: Option<&'a [BodyPeaks]>,
    /// The claims of that solution, where it is of another mesh; empty where it is of this one.
    pub elastic_claims: &'a [Figure],
    /// The claims of the solution in increments twice as large.
    pub doubled: Option<&'a [Figure]>,
}

/// The claims of a state: descent, bodies, interfaces.
pub fn certify(evidence: &Evidence) -> Vec<Figure> {
    let Evidence {
        scene,
        state,
        peaks,
        interfaces,
        ..
    } = *evidence;
    let missing_energy =
        MARGIN * energy::of_error(scene, state, evidence.recovered) * copies(scene);
    let tilted = scene.rigid_planes.iter().any(RigidPlane::is_turned);
    let too_stiff = tilted
        .then(|| too_stiff(evidence, missing_energy))
        .flatten();
    let mut claims: Vec<Figure> = descent_claim(evidence, missing_energy)
        .into_iter()
        .collect();
    let flowing = mises::claims(
        peaks,
        (evidence.elastic, evidence.elastic_claims),
        &Strip::all(scene, evidence.lines),
    );
    claims.extend(other::bores(evidence.bores));
    for (pair, interface) in interfaces.iter().enumerate() {
        let line = evidence.lines.get(pair).and_then(Option::as_ref);
        let contact = Contact {
            scene,
            state,
            pair,
            interface,
            line,
            edges: evidence.edges,
        };
        claims.extend(contact.claims());
        claims.extend(other::horizontal_force(scene, interface, line));
        if tilted {
            claims.extend(other::eccentricity(scene, interface, line, too_stiff));
        }
    }
    claims.extend(other::dents(evidence.dents, &flowing));
    claims.extend(flowing);
    let memory = Memory {
        flows: peaks.iter().any(|body| body.peeq_max > 0.0),
        rubs: scene.rubs(),
        elastic_elsewhere: !evidence.elastic_claims.is_empty(),
        doubled: evidence.doubled,
    };
    for claim in &mut claims {
        claim.error.increment = memory.error(claim);
        if claim.is_resolved() && claim.error.increment.is_none() {
            claim.note.get_or_insert(increments::UNKNOWN);
        }
        claim.error.penetration = penetration(claim, scene, interfaces);
    }
    claims
}

/// The smoothed stress is not the true one: of incompatible modes the estimate tends to the error from
/// below, by a hundredth on problem H.
const MARGIN: f64 = 1.05;

/// Travel of the loaded plane. A displacement method finds too little of it: the work of the load
/// on what is missing is the energy of the error. The smoothed stress sees the share of it that it sees of the energy
/// of the whole solution, which is itself too little by the same share.
fn descent_claim(evidence: &Evidence, missing_energy: f64) -> Option<Figure> {
    let Evidence { scene, state, .. } = *evidence;
    let value = descent(scene, state)?;
    let load = applied(scene, state);
    let driven = |m: &PlaneMotion| matches!(m, PlaneMotion::Driven(_));
    let by_force = !scene.tractions.is_empty()
        || (scene.rigid_planes.iter()).any(|plane| plane.motion.iter().any(driven));
    let error = missing(missing_energy / load, value) + unseen_approach(evidence);
    Some(Figure {
        error: Errors {
            // What is prescribed is known.
            discretisation: match by_force {
                true => Some(error)
                    .filter(|error| error.is_finite() && *error <= MOST_MISSING * value.abs()),
                false => Some(0.0),
            },
            ..Errors::default()
        },
        note: (!by_force).then_some("prescribed"),
        ..figure_of(Quantity::Descent, "overall", value)
    })
}

/// By which share the mesh is too stiff; `None` where nothing is known of it. What [`descent_claim`] says of a travel holds
/// of the energy of the whole, whatever a given angle adds to the travel.
fn too_stiff(evidence: &Evidence, missing_energy: f64) -> Option<f64> {
    let Evidence {
        scene,
        state,
        recovered,
        ..
    } = *evidence;
    let energy = energy::of_solution(scene, state, recovered) * copies(scene);
    let unseen = unseen_approach(evidence) * applied(scene, state).abs();
    let share = (missing(missing_energy, energy) + unseen) / energy;
    Some(share).filter(|share| share.is_finite() && *share <= MOST_MISSING)
}

/// What is missing of a travel of which the smoothed stress finds `estimate` missing: the share of the true travel
/// that the estimate is of the computed one, x / (1 − x) of that. Infinite where all of it would be.
fn missing(estimate: f64, travel: f64) -> f64 {
    let share = estimate / travel.abs();
    match share < 1.0 {
        true => estimate / (1.0 - share),
        false => f64::INFINITY,
    }
}

/// Of the travel, beyond which nothing is known of it.
const MOST_MISSING: f64 = 0.5;

/// How much closer bodies come below strips that the mesh is too coarse for. A line load q presses two half
/// spaces of the compliance C together by 2 q C/π times the logarithm of a length over the half-width a (Johnson,
/// Contact Mechanics, section 5.6); the mesh has its node spacing for a where that is more. The smoothed stress
/// knows nothing of it.
fn unseen_approach(evidence: &Evidence) -> f64 {
    let pairs = evidence.scene.contacts.iter().zip(evidence.lines);
    let of_pair = |(pair, line): (&ContactPair, &Option<HeaviestLine>)| {
        let line = line.as_ref()?;
        let (hertz, compliance) = (line.contact?, evidence.scene.compliance(pair).ok()?);
        let seen = line.line.heaviest.middle_spacing() / hertz.half_width;
        Some(2.0 * line.line_load * compliance / PI * seen.ln().max(0.0))
    };
    pairs.filter_map(of_pair).sum()
}

/// What penetration does to a figure: all of it to the descent, and to stresses and pressures the
/// stress of a strain of penetration over element size.
fn penetration(claim: &Figure, scene: &Scene, measured: &[Interface]) -> Option<f64> {
    // What is left is pressed together by both sides, the softer one most of all.
    let pressed = measured
        .iter()
        .zip(&scene.contacts)
        .filter_map(|(i, pair)| {
            let strain = i.contact_error / i.face_side?;
            Some((strain, strain / scene.compliance(pair).ok()?))
        });
    let (strain, stress) = pressed.fold((0.0f64, 0.0f64), |most, (strain, stress)| {
        (most.0.max(strain), most.1.max(stress))
    });
    let peak = measured.iter().map(|i| i.max_pressure).fold(0.0, f64::max);
    match claim.what {
        Quantity::Descent => Some(measured.iter().map(|i| i.contact_error).sum()),
        Quantity::PeakMises
        | Quantity::MisesAway
        | Quantity::ElasticPeakMises
        | Quantity::ElasticMisesAway
        | Quantity::BoreMises
        | Quantity::PeakPressure => Some(stress),
        Quantity::HalfWidth
        | Quantity::ContactArea
        | Quantity::ContactLength
        | Quantity::Eccentricity
        | Quantity::HertzPressure
        | Quantity::LineLoad
        | Quantity::HorizontalForce => (peak > 0.0).then(|| claim.value.abs() * stress / peak),
        Quantity::PeakPlasticStrain => Some(strain),
        Quantity::Dent => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An estimate that is the same share of a computed travel and of the true one finds what is missing whole.
    #[test]
    fn what_is_missing_is_a_share_of_the_true_travel() {
        let truth = 1.0;
        for share in [0.01, 0.2, 0.4] {
            let computed = (1.0 - share) * truth;
            let found = missing(share * computed, computed);
            assert!((computed + found - truth).abs() < 1e-12, "{share}: {found}");
        }
        assert!(missing(1.0, 1.0).is_infinite());
        assert!(missing(f64::NAN, 1.0).is_infinite());
    }
}
