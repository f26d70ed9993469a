//! What an answer is worth: figures with their estimated errors.
//!
//! A [`Claim`] is a figure of a run and how far it may be off, by cause. The estimates come from
//! the one mesh that was solved: from the stress that a smoother field would have
//! ([`energy`]), from readings that tend to the same value (`mises`), and from how well the nodes
//! resolve the pressure (`pressure`). A bar is meant to hold in 95 of 100 cases.

pub mod energy;
mod mises;
mod other;
mod pressure;

use crate::results::State;
use crate::results::bore::BoreStress;
use crate::results::edges::LoadedEdges;
use crate::results::hertz::HeaviestLine;
use crate::results::interface::Interface;
use crate::results::load::{applied, copies, descent};
use crate::results::peaks::BodyPeaks;
use crate::results::recovery::Recovered;
use crate::scene::{ContactPair, PlaneMotion, Scene};
use mises::Strip;
use pressure::Contact;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use std::f64::consts::PI;

/// A figure and what it is worth.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Such as "peak Mises, nodal".
    pub what: Quantity,
    /// Body or interface; "overall" for the scene.
    pub place: String,
    pub value: f64,
    /// By cause.
    pub error: Errors,
    /// Why the figure or its error should be read with care.
    pub note: Option<&'static str>,
}

impl Claim {
    /// What the figure may be off by, in its unit; `None` where nothing can be said.
    pub fn bar(&self) -> Option<f64> {
        self.error.total().filter(|error| error.is_finite())
    }

    /// The same, of the figure; `None` of zero, too.
    pub fn relative_bar(&self) -> Option<f64> {
        let share = self.bar()? / self.value.abs();
        share.is_finite().then_some(share)
    }

    /// Is its error known?
    pub fn is_resolved(&self) -> bool {
        self.bar().is_some()
    }
}

impl Serialize for Claim {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut claim = serializer.serialize_struct("Claim", 8)?;
        claim.serialize_field("what", &self.what)?;
        claim.serialize_field("where", &self.place)?;
        claim.serialize_field("value", &self.value)?;
        claim.serialize_field("error", &self.bar())?;
        claim.serialize_field("relative_error", &self.relative_bar())?;
        claim.serialize_field("resolved", &self.is_resolved())?;
        claim.serialize_field("note", &self.note)?;
        claim.serialize_field("causes", &self.error)?;
        claim.end()
    }
}

/// The figures of which nothing can be said, and that nothing is said in place of: beside a peak at a
/// loaded edge, which has no limit, stands the peak away from such edges.
pub fn unresolved(claims: &[Claim]) -> Vec<&Claim> {
    let replaced = |c: &Claim| {
        let away = c.what.away_from_edges();
        away.is_some_and(|away| claim(claims, away, &c.place).is_some())
    };
    let unsure = claims.iter().filter(|c| !c.is_resolved());
    unsure.filter(|c| !replaced(c)).collect()
}

/// The claim of `what` at `place`.
pub fn claim<'c>(claims: &'c [Claim], what: Quantity, place: &str) -> Option<&'c Claim> {
    claims.iter().find(|c| c.what == what && c.place == place)
}

/// What a claim is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    Descent,
    /// Largest nodal Mises stress of a body.
    PeakMises,
    /// Where that lies at a loaded edge: the largest away from such edges.
    MisesAway,
    /// The same two of the elastic solution, where the body has yielded.
    ElasticPeakMises,
    ElasticMisesAway,
    /// Largest equivalent plastic strain at an integration point.
    PeakPlasticStrain,
    /// Largest consistent nodal pressure.
    PeakPressure,
    /// Hertz's pressure under the largest load per length.
    HertzPressure,
    /// Largest load per length, normal to the surface.
    LineLoad,
    /// Half-width of the strip, or of the most heavily loaded line of contact.
    HalfWidth,
    ContactArea,
    /// Length in contact of the most heavily loaded line.
    ContactLength,
    /// Mises stress on the inner wall below the load.
    BoreMises,
    /// Force of an interface across the load.
    HorizontalForce,
    /// Depth of a dent that stays.
    Dent,
}

/// Estimated errors of a figure, in its unit and without sign; `None` where nothing is known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Of the mesh.
    pub discretisation: Option<f64>,
    /// Of the penetration that is left.
    pub penetration: Option<f64>,
    /// Of the size of the increments in plastic flow, what friction remembers meanwhile included: zero
    /// where nothing depends on the path.
    pub increment: Option<f64>,
}

impl Errors {
    /// Their sum, as far as they are known; `None` where the error of the mesh is not.
    pub fn total(&self) -> Option<f64> {
        let rest = self.penetration.unwrap_or(0.0) + self.increment.unwrap_or(0.0);
        self.discretisation.map(|mesh| mesh + rest)
    }
}

impl Quantity {
    /// Of a Mises peak, the one away from loaded edges.
    pub fn away_from_edges(self) -> Option<Self> {
        match self {
            Self::PeakMises => Some(Self::MisesAway),
            Self::ElasticPeakMises => Some(Self::ElasticMisesAway),
            _ => None,
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Descent => "descent",
            Self::PeakMises => "peak Mises, nodal",
            Self::MisesAway => "Mises away from edges, nodal",
            Self::ElasticPeakMises => "peak Mises, elastic, nodal",
            Self::ElasticMisesAway => "Mises away from edges, elastic, nodal",
            Self::PeakPlasticStrain => "peak plastic strain",
            Self::PeakPressure => "peak pressure",
            Self::HertzPressure => "Hertz's p0 of the line load",
            Self::LineLoad => "largest line load",
            Self::HalfWidth => "half-width",
            Self::ContactArea => "contact area",
            Self::ContactLength => "length in contact",
            Self::BoreMises => "bore Mises",
            Self::HorizontalForce => "horizontal force",
            Self::Dent => "dent",
        }
    }

    /// What it is measured in.
    pub fn measure(self) -> Measure {
        match self {
            Self::Descent | Self::HalfWidth | Self::ContactLength | Self::Dent => Measure::Length,
            Self::PeakMises
            | Self::MisesAway
            | Self::ElasticPeakMises
            | Self::ElasticMisesAway
            | Self::PeakPressure
            | Self::HertzPressure
            | Self::BoreMises => Measure::Stress,
            Self::LineLoad => Measure::LineLoad,
            Self::ContactArea => Measure::Area,
            Self::HorizontalForce => Measure::Force,
            Self::PeakPlasticStrain => Measure::Ratio,
        }
    }
}

/// What a quantity is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    Length,
    Area,
    Force,
    LineLoad,
    Stress,
    Ratio,
}

/// A claim of which nothing is known yet.
fn claim_of(what: Quantity, place: &str, value: f64) -> Claim {
    Claim {
        what,
        place: place.to_owned(),
        value,
        error: Errors::default(),
        note: None,
    }
}

/// What is certified.
#[derive(Debug, Clone, Copy)]
pub struct Evidence<'a> {
    pub scene: &'a Scene,
    pub state: &'a State,
    pub recovered: &'a Recovered,
    /// Peaks of every body and scalars of every contact pair, in their orders.
    pub peaks: &'a [BodyPeaks],
    pub interfaces: &'a [Interface],
    /// The heaviest line of every pair, where it has lines.
    pub lines: &'a [Option<HeaviestLine>],
    pub edges: &'a LoadedEdges,
    /// Inner walls of rollers by body.
    pub bores: &'a [(String, BoreStress)],
    /// Dents that stay: surface, its body and depth.
    pub dents: &'a [(String, String, f64)],
    /// Peaks of the elastic solution at the same load, in the order of the bodies.
    pub elastic: Option<&'a [BodyPeaks]>,
    /// The claims of the solution in increments twice as large.
    pub doubled: Option<&'a [Claim]>,
}

/// The claims of a state: descent, bodies, interfaces.
pub fn certify(evidence: &Evidence) -> Vec<Claim> {
    let Evidence {
        scene,
        state,
        peaks,
        interfaces,
        ..
    } = *evidence;
    let mut claims: Vec<Claim> = descent_claim(evidence).into_iter().collect();
    let flowing = mises::claims(peaks, evidence.elastic, &Strip::all(scene, evidence.lines));
    claims.extend(other::bores(evidence.bores));
    for (pair, interface) in interfaces.iter().enumerate() {
        let contact = Contact {
            scene,
            state,
            pair,
            interface,
            line: evidence.lines.get(pair).and_then(Option::as_ref),
            edges: evidence.edges,
        };
        claims.extend(contact.claims());
        claims.extend(other::horizontal_force(scene, interface));
    }
    claims.extend(other::dents(evidence.dents, &flowing));
    claims.extend(flowing);
    // Plastic flow and friction are integrated along the path.
    let remembers = peaks.iter().any(|body| body.peeq_max > 0.0)
        || scene.contacts.iter().any(|c| c.friction > 0.0);
    for claim in &mut claims {
        claim.error.increment = match remembers {
            true => increment(claim, evidence.doubled),
            false => Some(0.0),
        };
        claim.error.penetration = penetration(claim, scene, interfaces);
    }
    claims
}

/// The smoothed stress is not the true one: of incompatible modes the estimate tends to the error from
/// below, by a hundredth on problem H.
const MARGIN: f64 = 1.05;

/// Travel of the loaded plane. A displacement method finds too little of it: the work of the load
/// on what is missing is the energy of the error.
fn descent_claim(evidence: &Evidence) -> Option<Claim> {
    let Evidence { scene, state, .. } = *evidence;
    let value = descent(scene, state)?;
    let load = applied(scene, state);
    let driven = |m: &PlaneMotion| matches!(m, PlaneMotion::Driven(_));
    let by_force = !scene.tractions.is_empty()
        || (scene.rigid_planes.iter()).any(|plane| plane.motion.iter().any(driven));
    let energy = MARGIN * energy::of_error(scene, state, evidence.recovered) * copies(scene);
    Some(Claim {
        what: Quantity::Descent,
        place: "overall".to_owned(),
        value,
        error: Errors {
            // What is prescribed is known.
            discretisation: match by_force {
                true => (load > 0.0).then(|| energy / load + unseen_approach(evidence)),
                false => Some(0.0),
            },
            ..Errors::default()
        },
        note: (!by_force).then_some("prescribed"),
    })
}

/// The error of the increments, over the difference that doubling them makes. It would be one where the error
/// of an increment grows with the square of its size and flow is smooth; corners begin to flow one by one.
pub const DOUBLING: f64 = 1.5;

/// What the size of the increments does to a figure, from the same figure in increments twice as large.
fn increment(claim: &Claim, doubled: Option<&[Claim]>) -> Option<f64> {
    match claim.what {
        // Of another solution, which only friction ties to its path.
        Quantity::ElasticPeakMises | Quantity::ElasticMisesAway => None,
        what => {
            let other = self::claim(doubled?, what, &claim.place)?;
            Some(DOUBLING * (claim.value - other.value).abs())
        }
    }
}

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
fn penetration(claim: &Claim, scene: &Scene, measured: &[Interface]) -> Option<f64> {
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
        | Quantity::HertzPressure
        | Quantity::LineLoad
        | Quantity::HorizontalForce => (peak > 0.0).then(|| claim.value * stress / peak),
        Quantity::PeakPlasticStrain => Some(strain),
        Quantity::Dent => None,
    }
}
