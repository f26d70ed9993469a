//! The travel of what is loaded, and how much of it the mesh misses.

use super::contacts::{Contacts, MOST_MISSING, overlap_of_strip, unseen_approach};
use super::facets;
use super::figure::{Errors, Figure, Quantity, figure_of};
use super::flow_shares::FlowShares;
use super::notes::{MEAN_OF_MOTIONS, UNKNOWN_STIFFNESS};
use super::outside::Outside;
use super::{energy, held_ends};
use crate::answer::results::edges::SingularEdges;
use crate::answer::results::load::{applied, copies, descent, forced_share, is_mean_of_motions};
use crate::answer::results::recovery::Recovered;
use crate::model::scene::{PlaneMotion, Scene};
use crate::model::state::State;

/// Of what the smoothed stress finds missing, what is missing: where bodies end nothing is averaged, and the error looks
/// larger than it is. Measured on bearings (docs/coverage.md).
const LIKELY: f64 = 0.7;

/// Of the same, how far off that may be.
const SPREAD: f64 = 0.5;

/// Of the root of the estimate over the travel, times the share of the energy that plastic flow has spent: flow begins element by
/// element, so that its extent is off by a share of an element. What smooth fields miss is of the second order of the
/// spacing, and its root of the first. (Of 56 travels of plane strips with p0 of 1.9 to 4.8 times yield and 1 to 56 % of the energy, drawn by two
/// seeds, 55 are within, 43 with 0.9.)
const OF_FLOW: f64 = 1.4;

/// Of the estimate and of the root of the share that is spent by flow that no strip is above, as of a ring that bends. Such flow
/// begins by itself where stress reaches yield: its energy grows with the square of the excess, and what an error of the
/// stress makes of it with the root of that energy. (Of 24 travels of rollers in V-blocks, rings among them, 9 are outside
/// without it, 4 with it.)
const OF_FREE_FLOW: f64 = 2.0;

/// Of the travel and of the root of what stress [beyond flow](FlowShares::beyond) says: where most of a body flows elements follow Hooke's law no
/// longer, and an error of stress strains them more, by E/H. (Of 56 travels of pads that are pressed on one another, half of
/// which flow, 13 were outside without it, 6 with it.)
const OF_FLOW_BEYOND: f64 = 0.5;

/// Of the energy of the error of bodies that no long strip presses, how far off what it says may be. Where contact along a
/// strip makes most of it, it is too large by much the same on all meshes; elsewhere it may be all there or partly taken
/// back by what elements assume.
const OF_ERROR: f64 = 0.7;

/// Of the energy of the error beside singular edges, how much more there may be: where stress has no bound its averages see
/// half of it. (Of 70 travels of flat wedges pressed into seats, whose edges lie anywhere on the facets of the other side, 19 were
/// outside without it; of 460 of other kinds, with the inner corners of V-blocks and of T-stubs, 47, and 36 with it.)
const AT_EDGES: f64 = 1.0;

/// Of the [energy at held ends](held_ends::unseen_energy), what is missing, and how far off that may be. (Of 14 clamped beams of
/// the enhanced hexahedron, drawn at random, the travels of 7 are outside without it, short by 0.4 to 1.2 of that energy; of 80 of other
/// seeds one is outside with it.)
const OF_ENDS: f64 = 0.5;

/// Of the overlap that bodies are brought into touch with, where no long strip tells, over [`LIKELY`]: of 126 spheres, crossed
/// cylinders and unstructured meshes travels were short by 0.1 to 0.8 of it.
const OF_OVERLAP: f64 = 0.65;

/// How far what is loaded moves along the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Travel {
    /// That of the nodes.
    pub of_mesh: f64,
    /// What the mesh misses; `None` where it is prescribed and so known.
    missing: Option<MissedByMesh>,
    /// Is it a mean over motions that are prescribed and differ?
    is_mean: bool,
}

/// What a mesh misses of a travel.
#[derive(Debug, Clone, Copy, PartialEq)]
struct MissedByMesh {
    /// As the smoothed stress and the strips have it; not a number, or infinite, where they say nothing.
    estimate: f64,
    /// What is missing at held ends, between none and twice [`OF_ENDS`] of this.
    at_ends: f64,
    /// What may be missing besides.
    perhaps: f64,
    /// Is it known to be missing, and not too much? A load on its way up, on bodies that are not warmed, moves too little.
    is_less: bool,
    flow: FlowShares,
    /// What is wrong with flow of earlier steps, and stays.
    stays: f64,
}

impl Travel {
    /// In `state`, `contacts` being what every pair carries; `None` where nothing loads the scene.
    ///
    /// A displacement method finds too little of it: the work of the load on what is missing is the
    /// [energy of the error](energy::missing_work).
    pub fn of(
        scene: &Scene,
        state: &State,
        recovered: &Recovered,
        (contacts, outside, edges): (Contacts, &Outside, &SingularEdges),
    ) -> Option<Self> {
        let of_mesh = descent(scene, state)?;
        let driven = |m: &PlaneMotion| matches!(m, PlaneMotion::Driven(_));
        let mut planes = scene.rigid_planes.iter();
        let by_force =
            !scene.tractions.is_empty() || planes.any(|plane| plane.motion.iter().any(driven));
        // What is moved by a given travel misses nothing of it.
        let forced = forced_share(scene, state);
        let missing = by_force.then(|| {
            let outer = &outside.faces;
            let by_mesh = energy::missing_work(scene, state, recovered, (outer, edges));
            let seen = missing(
                by_mesh.work * copies(scene) / applied(scene, state),
                of_mesh,
            );
            let errors = by_mesh.errors.iter().enumerate();
            let unlike_strips = errors.filter(|(body, _)| !contacts.is_below_strip(scene, *body));
            let unlike_strips = unlike_strips.map(|(_, error)| error).sum::<f64>() * copies(scene);
            let at_ends = held_ends::unseen_energy(scene, state, recovered, outer) * copies(scene);
            let facets = facets::off(scene, contacts, outside);
            let of_facets = facets.iter().any(|off| *off > 0.0).then(|| {
                let energies = energy::of_bodies(scene, state, recovered).into_iter();
                energies
                    .zip(facets)
                    .map(|(energy, off)| energy * off)
                    .sum::<f64>()
            });
            let of_facets = of_facets.unwrap_or(0.0) * copies(scene);
            let beside_edges = AT_EDGES * by_mesh.beside_edges * copies(scene);
            let at_touch = |part: usize| {
                contacts.work_below_strips(scene, |line, hertz, _| {
                    overlap_of_strip(&line.line.heaviest, hertz)[part]
                })
            };
            let below_strips = contacts.work_below_strips(scene, unseen_approach) + at_touch(0);
            let elsewhere = OF_OVERLAP * contacts.work_elsewhere(scene);
            let of_load = forced / applied(scene, state);
            MissedByMesh {
                estimate: forced * seen + of_load * (below_strips + elsewhere),
                perhaps: contacts.rolls(scene)
                    + of_load * at_touch(1).abs()
                    + (forced * (OF_ERROR * unlike_strips + beside_edges + of_facets)
                        / applied(scene, state))
                    .abs(),
                at_ends: (forced * at_ends / applied(scene, state)).abs(),
                flow: FlowShares::of(scene, state, recovered, contacts),
                stays: 0.0,
                is_less: scene.temperatures.is_empty() && !scene.unloads(state.step),
            }
        });
        Some(Self {
            of_mesh,
            missing,
            is_mean: !by_force && is_mean_of_motions(scene, state),
        })
    }

    /// After others, at the ends of earlier steps: of the error of what has flowed by then nothing goes back as loads do.
    pub fn after(mut self, earlier: impl Iterator<Item = Self>) -> Self {
        if let Some(missing) = &mut self.missing {
            let of_flow = |travel: Self| {
                let flow = travel.missing?.flow;
                Some((flow.below_strips + flow.away) * travel.error()?)
            };
            missing.stays = earlier.filter_map(of_flow).fold(0.0, f64::max);
        }
        self
    }

    /// By which share stresses are off, in the mean: the root of the energy of the error. All of them where nothing is known, none where the
    /// travel is prescribed.
    pub(super) fn stress_off(&self) -> f64 {
        if self.missing.is_none() {
            return 0.0;
        }
        let share = |missing: MissedByMesh| (missing.estimate / self.of_mesh).abs().sqrt();
        self.known().map_or(1.0, share)
    }

    /// With what the mesh is likely to miss, where that is known.
    pub fn value(&self) -> f64 {
        let missing = self.known().filter(|missing| missing.is_less);
        let likely = |missing: MissedByMesh| LIKELY * missing.estimate + OF_ENDS * missing.at_ends;
        self.of_mesh + missing.map_or(0.0, likely)
    }

    /// How far the value may be off; `None` where nothing is known of it.
    pub(super) fn error(&self) -> Option<f64> {
        if self.missing.is_none() {
            return Some(0.0);
        }
        self.known().map(|missing| {
            let estimate = missing.estimate.abs();
            let sign = if missing.is_less { 0.0 } else { LIKELY };
            let share = sign + OF_FREE_FLOW * missing.flow.away.sqrt();
            let begins =
                OF_FLOW * missing.flow.below_strips * (estimate * self.of_mesh.abs()).sqrt();
            let ends = if missing.is_less {
                OF_ENDS
            } else {
                2.0 * OF_ENDS
            } * missing.at_ends;
            let beyond = OF_FLOW_BEYOND * missing.flow.beyond.sqrt() * self.of_mesh.abs();
            share * estimate
                + begins.hypot(SPREAD * estimate)
                + ends
                + beyond
                + missing.stays
                + missing.perhaps.abs()
        })
    }

    /// By which share of the value bodies that stay elastic may bend otherwise; all of it where nothing is known. Nothing where the travel
    /// is prescribed.
    pub(super) fn off(&self) -> f64 {
        if self.missing.is_none() {
            return 0.0;
        }
        self.known().map_or(1.0, |missing| {
            let ends = OF_ENDS * missing.at_ends;
            let error = SPREAD * missing.estimate.abs() + ends + missing.perhaps.abs();
            (error / self.value()).abs().min(1.0)
        })
    }

    /// By which share of the value that of the nodes may differ from the true one, as [`Self::off`].
    pub(super) fn off_mesh(&self) -> f64 {
        (self.of_mesh / self.value() - 1.0).abs() + self.off()
    }

    fn known(&self) -> Option<MissedByMesh> {
        let most = MOST_MISSING * self.of_mesh.abs();
        self.missing
            .filter(|missing| missing.estimate.abs() <= most)
    }
}

const PRESCRIBED: &str = "prescribed";

/// The claim of the travel.
pub(super) fn claim(travel: Travel) -> Figure {
    let error = travel.error().filter(|_| !travel.is_mean);
    let note = match travel.missing {
        None if travel.is_mean => Some(MEAN_OF_MOTIONS),
        None => Some(PRESCRIBED),
        Some(_) => error.is_none().then_some(UNKNOWN_STIFFNESS),
    };
    Figure {
        error: Errors::only_of_mesh(error),
        note,
        ..figure_of(Quantity::Descent, "overall", travel.value())
    }
}

/// By which share the mesh is too stiff at most; `None` where nothing is known of it. What holds of a [`Travel`] holds
/// of the energy of the whole, whatever a given angle adds to the travel.
pub(super) fn too_stiff(
    scene: &Scene,
    state: &State,
    recovered: &Recovered,
    (contacts, outside, edges): (Contacts, &Outside, &SingularEdges),
) -> Option<f64> {
    let of_whole = |energy: f64| energy * copies(scene);
    let energy = of_whole(energy::of_solution(scene, state, recovered));
    let work =
        of_whole(energy::missing_work(scene, state, recovered, (&outside.faces, edges)).work);
    let unseen = contacts.work_below_strips(scene, unseen_approach).abs();
    let share = (LIKELY + SPREAD) * (missing(work, energy).abs() + unseen) / energy;
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

    #[test]
    fn what_is_likely_is_added_only_where_the_sign_is_known() {
        let travel = |estimate: f64, is_less: bool| Travel {
            of_mesh: 1.0,
            missing: Some(MissedByMesh {
                estimate,
                at_ends: 0.0,
                perhaps: 0.01,
                is_less,
                flow: FlowShares::default(),
                stays: 0.0,
            }),
            is_mean: false,
        };
        let loaded = travel(0.1, true);
        assert_eq!(loaded.value(), 1.0 + LIKELY * 0.1);
        assert_eq!(loaded.error(), Some(SPREAD * 0.1 + 0.01));
        let unloaded = travel(0.1, false);
        assert_eq!(unloaded.value(), 1.0);
        assert_eq!(unloaded.error(), Some((LIKELY + SPREAD) * 0.1 + 0.01));
        for unknown in [travel(0.6, true), travel(f64::INFINITY, true)] {
            assert_eq!((unknown.value(), unknown.error()), (1.0, None));
        }
        let mut flows = travel(0.04, true);
        let missing = flows.missing.as_mut().unwrap();
        missing.flow.below_strips = 0.1;
        let wanted = (OF_FLOW * 0.1 * 0.2).hypot(SPREAD * 0.04) + 0.01;
        assert!(
            flows
                .error()
                .is_some_and(|error| (error - wanted).abs() < 1e-15)
        );
        let prescribed = Travel {
            of_mesh: 1.0,
            missing: None,
            is_mean: false,
        };
        assert_eq!((prescribed.value(), prescribed.error()), (1.0, Some(0.0)));
    }
}
