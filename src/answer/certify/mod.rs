//! What an answer is worth: figures with their estimated errors.
//!
//! A [`Figure`] is a figure of a run and how far it may be off, by cause. The estimates come from
//! the one mesh that was solved: from the stress that a smoother field would have
//! ([`energy`]), from readings that tend to the same value (`mises`), and from how well the nodes
//! resolve the pressure (`pressure`). A bar is meant to hold in 95 of 100 cases.

mod at_bore;
mod below_patches;
mod contact;
mod contacts;
mod descent;
mod earlier;
pub mod energy;
mod facets;
mod fall;
mod figure;
mod flow_shares;
mod half_spaces;
mod held_ends;
mod increments;
mod line;
mod linings;
mod mises;
mod notes;
mod other;
mod outside;
mod plastic_strain;
mod pressure;
mod rim;
mod scatter;
mod strain_energy;
mod strip_below;
mod thin_walls;

use crate::answer::checks::NOTABLE_SHARE;
use crate::answer::results::bore::BoreStress;
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::peaks::BodyPeaks;
use crate::answer::results::recovery::Recovered;
use crate::model::scene::{RigidPlane, Scene};
use crate::model::state::State;
use at_bore::AtBore;
use below_patches::BelowPatches;
use contact::{Contact, Touch};
use increments::Memory;
use strip_below::StripBelow;

pub use contacts::Contacts;
pub use descent::Travel;
pub use earlier::Earlier;
pub use figure::{Errors, Figure, Quantity, figure, is_replaced, unresolved};
pub use increments::{DOUBLING, WITHOUT_INCREMENTS};
pub use outside::Outside;

/// What is certified.
#[derive(Clone, Copy)]
pub struct Evidence<'a> {
    /// The solved scene.
    pub scene: &'a Scene,
    /// The state that is certified.
    pub state: &'a State,
    /// The outsides of its bodies.
    pub outside: &'a Outside<'a>,
    /// Stresses at nodes and in elements of that state.
    pub recovered: &'a Recovered,
    /// The ends of the steps before.
    pub earlier: &'a [Earlier<'a>],
    /// Of what is loaded, in that state.
    pub travel: Option<Travel>,
    /// Peaks of every body and scalars of every contact pair, in their orders.
    pub peaks: &'a [BodyPeaks],
    /// Scalars of every contact pair, in their order.
    pub interfaces: &'a [Interface],
    /// The heaviest line of every pair, where it has lines.
    pub lines: &'a [Option<HeaviestLine>],
    /// Where stresses have no bound.
    pub edges: &'a SingularEdges,
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
    let tilted = scene.rigid_planes.iter().any(RigidPlane::is_turned);
    let contacts = Contacts {
        interfaces,
        lines: evidence.lines,
    };
    let too_stiff = || {
        let seen = (contacts, evidence.outside, evidence.edges);
        descent::too_stiff(scene, state, evidence.recovered, seen)
    };
    let of_linings = linings::too_stiff(scene, state, evidence.recovered, &evidence.outside.faces);
    let moved = scene.is_moved();
    let too_stiff = (tilted || moved).then(too_stiff).flatten();
    let by_motion = if moved {
        too_stiff.unwrap_or(f64::INFINITY)
    } else {
        0.0
    };
    let mut claims: Vec<Figure> = evidence.travel.map(descent::claim).into_iter().collect();
    claims.extend(other::bores(evidence.bores));
    let missed_travel = evidence.travel.and_then(|travel| travel.error());
    let before = if moved { evidence.earlier } else { &[] };
    let horizontal = other::horizontal_forces(
        (scene, evidence.state),
        contacts,
        (missed_travel, by_motion, before),
    );
    let pushed = other::pushed_across(scene, state);
    let off_mesh = evidence.travel.map_or(0.0, |travel| travel.off_mesh());
    let travel_off = evidence.travel.map_or(0.0, |travel| travel.off());
    let pokes = evidence.travel.is_some_and(|travel| {
        let most = NOTABLE_SHARE * travel.value().abs();
        interfaces.iter().any(|i| i.unexplained_penetration > most)
    });
    let mut unclear = pokes.then_some(notes::POKES);
    let mut touches = Vec::new();
    for (pair, interface) in interfaces.iter().enumerate() {
        let line = evidence.lines.get(pair).and_then(Option::as_ref);
        let touch = Touch::of(scene, pair, line);
        touches.push(touch);
        let contact = Contact {
            scene,
            state,
            recovered: evidence.recovered,
            pair,
            interface,
            line,
            touch,
            edges: &evidence.edges.loaded,
            too_stiff: by_motion,
            linings_off: linings::off(scene, pair, &of_linings),
            travel_off,
            shared_off: contacts.shared_off((scene, state), pair, off_mesh),
        };
        let own = contact.claims();
        unclear = unclear.or(contact.has_no_shape(&own).then_some(notes::SHAPE));
        let mut across = horizontal.get(pair).cloned().flatten();
        let is_strip = line.is_some_and(|line| line.contact.is_some());
        if let Some(across) = across.as_mut().filter(|_| !is_strip) {
            let sticks = interface.status_counts.stick > 0;
            other::add_rim(across, &own, sticks, pushed);
        }
        if let Some(across) = across.as_mut().filter(|_| pokes) {
            across.leave_open(notes::POKES);
        }
        claims.extend(own);
        claims.extend(across);
        if tilted {
            claims.extend(other::eccentricity(scene, interface, line, too_stiff));
        }
    }
    let descent = claims.first_mut().filter(|c| c.what == Quantity::Descent);
    if let (Some(descent), Some(why)) = (descent, unclear) {
        descent.leave_open(why);
    }
    let strips = StripBelow::all(scene, evidence.lines);
    let patches = BelowPatches::new((scene, state), interfaces, &touches, &claims);
    let elastic = (evidence.elastic, evidence.elastic_claims);
    let facets = facets::off(scene, contacts, evidence.outside);
    let below = (strips.as_slice(), &patches, &facets[..], travel_off);
    let pressures_off = interfaces.iter().zip(evidence.lines);
    let pressures_off: Vec<Option<f64>> = pressures_off
        .map(|(interface, line)| line::strip_off(line.as_ref()?, &claims, &interface.name))
        .collect();
    let bores = AtBore::all(evidence.bores, &claims);
    let beside = (pressures_off.as_slice(), bores.as_slice());
    let flowing = mises::claims((peaks, evidence.earlier), elastic, below, beside);
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
            claim.note.get_or_insert(WITHOUT_INCREMENTS);
        }
        claim.error.penetration = penetration(claim, scene, interfaces);
    }
    claims
}

/// What penetration does to a figure: all of it to the descent, where facets do not explain it (at steep rims, too), and to stresses and
/// pressures the stress of a strain of penetration over element size.
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
        Quantity::Descent => {
            let missed = measured.iter();
            Some(
                missed
                    .map(|i| {
                        i.contact_error
                            .max(i.unexplained_penetration)
                            .max(i.rim_penetration)
                    })
                    .sum(),
            )
        }
        Quantity::PeakMises
        | Quantity::MisesAway
        | Quantity::ElasticPeakMises
        | Quantity::ElasticMisesAway
        | Quantity::BoreMises
        | Quantity::PeakPressure
        | Quantity::PressureAway => Some(stress),
        Quantity::HalfWidth
        | Quantity::ContactArea
        | Quantity::ContactLength
        | Quantity::Eccentricity
        | Quantity::HertzPressure
        | Quantity::LineLoad
        | Quantity::LineLoadAway
        | Quantity::HorizontalForce => (peak > 0.0).then(|| claim.value.abs() * stress / peak),
        Quantity::PeakPlasticStrain => Some(strain),
        Quantity::Dent => None,
    }
}
