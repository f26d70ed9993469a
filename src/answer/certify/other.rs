//! Bores, horizontal forces, eccentricities and dents.

use super::contacts::Contacts;
use super::earlier::Earlier;
use super::figure::{Errors, Figure, Quantity, figure, figure_of};
use super::line::turned_by_place;
use super::notes::{COARSE, UNKNOWN_STIFFNESS};
use super::scatter;
use crate::answer::results::bore::BoreStress;
use crate::answer::results::hertz::HeaviestLine;
use crate::answer::results::interface::Interface;
use crate::answer::results::line_frame::is_mirrored;
use crate::answer::results::load::{main_direction, prescribed};
use crate::ground::geometry::{Vec3, dot, norm, scale, sub};
use crate::model::scene::Scene;
use crate::model::state::State;

/// What the strain of the surface of a bore misses of the stress there, of itself, for elements as deep as the bore's
/// radius: the stress falls from the wall as fast as the wall is curved.
const DEPTH: f64 = 0.2;

/// The same for facets of one radian about the axis: a ring of chords bends less than a round one.
const FACET: f64 = 0.7;

/// The same for facets as long as the wall is thick: bilinear elements that bend shear as well, by the square of
/// their length over the depth that bends, however many of them share it (parasitic shear). Of walls of 0.06 to 0.12 D and facets
/// of D/6 the stress is 9 to 31 % of itself too little, and 0.7 of the square of the facet says 8 of these.
const SLENDER: f64 = 0.04;

/// Of the depth of elements over the thickness of the wall, how far the bending of a thin wall may be off at least: elements have one
/// pressure all through, and what is round costs little there. Against walls of incompatible modes 0.06 to 0.09, too large.
const LAYER: f64 = 0.1;

/// The same for facets as long as the wall is thick that are half the wall beside the load: there shear turns into bending, and
/// meshes that grow fast beside a fine strip make too much of it. It is of the first order. (Walls of 0.10 to 0.16 D, against incompatible
/// modes and meshes that grow by 1.15: 0.05 to 0.11 of the length of that facet.)
const BESIDE_LOAD: f64 = 0.1;

/// What is missing of the stress of a bore, of itself: errors of second order, measured on bearings (docs/coverage.md).
/// Of elements deeper than the bore the first cannot be more than the share of the stress that falls so fast.
fn bore_share(stress: &BoreStress) -> f64 {
    let depth = DEPTH * stress.coarseness.powi(2);
    let round = FACET * stress.facet.powi(2);
    let round_and_deep = depth / (1.0 + 2.0 * depth) + round;
    (round_and_deep + SLENDER * stress.slenderness.powi(2))
        .max(LAYER * stress.of_wall)
        .max(BESIDE_LOAD * stress.beside_load)
}

const YIELDED: &str =
    "the wall has yielded below the load: the strain of its surface says no stress";

/// Mises stress on the inner walls of rollers.
pub(super) fn bores(bores: &[(String, BoreStress)]) -> Vec<Figure> {
    let claim = |(body, stress): &(String, BoreStress)| {
        let nodal = stress.nodal?;
        let value = stress.mises.unwrap_or(nodal);
        Some(Figure {
            error: Errors::only_of_mesh(stress.mises.map(|mises| mises * bore_share(stress))),
            note: stress.mises.is_none().then_some(YIELDED),
            ..figure_of(Quantity::BoreMises, body, value)
        })
    };
    bores.iter().filter_map(claim).collect()
}

/// Share of a horizontal force that depends on the mesh, over the distance of the nodes in half-widths of the strip:
/// shears settle as contact grows, node by node. The largest of 108 readings of bearings is 0.026 (docs/coverage.md).
const SHEAR: f64 = 0.03;

/// Of the force by which shears differ from those of the nodes beside them, that which their sum may be off by: where they turn, as beside a mirror
/// plane, a node stands for both. (Of 185 forces of pads, wedges, rings and what is dragged 19 were outside without it, 10 with it; of 70
/// drawn afterwards 4, and 2.)
const OF_TURNS: f64 = 0.5;

/// The forces of all interfaces across the largest load that acts, in their order; `None` where there is none.
///
/// Bodies that nothing else holds pass such a force from contact to contact: it is as well known as at the worst of those
/// that carry the same. Where a motion is prescribed, every change since the forces `before`, at the ends of earlier steps,
/// adds to the error: of what has been taken back, little may be left. Such forces are too large by the share by which the mesh is `too_stiff`.
pub(super) fn horizontal_forces(
    (scene, state): (&Scene, &State),
    contacts: Contacts,
    (missed_travel, too_stiff, before): (Option<f64>, f64, &[Earlier]),
) -> Vec<Option<Figure>> {
    /// Of the force along the load, how far forces differ that are the same.
    const SAME: f64 = 1e-6;
    let along = main_direction(scene, state);
    let across = |force: &Vec3| part_across(along, *force);
    let of_pair = |(pair, interface): (usize, &Interface)| {
        let line = contacts.lines.get(pair).and_then(Option::as_ref);
        let earlier = before.iter().filter_map(|end| end.forces.get(pair));
        let course = earlier.chain([&interface.force]).map(across);
        let is_strip = line.is_some_and(|line| line.contact.is_some());
        let field = state.contacts.get(pair).filter(|_| !is_strip);
        let turns = field.map_or(0.0, |field| scatter::of_tractions(scene, field, pair));
        horizontal_force(
            interface,
            line,
            (missed_travel, too_stiff, turns, course.collect()),
        )
    };
    let alone: Vec<_> = (contacts.interfaces.iter().enumerate())
        .map(of_pair)
        .collect();
    let worst_of_same = |(figure, interface): (&Option<Figure>, &Interface)| {
        let mut figure = figure.clone()?;
        let same = |other: &&Figure| {
            (other.value - figure.value).abs() <= SAME * interface.normal_force.abs()
        };
        let errors = alone.iter().flatten().filter(same);
        let errors = errors.filter_map(|other| other.error.discretisation);
        figure.error.discretisation = errors.reduce(f64::max);
        Some(figure)
    };
    (alone.iter().zip(contacts.interfaces))
        .map(worst_of_same)
        .collect()
}

/// Size of the prescribed forces across the largest load that acts.
pub(super) fn pushed_across(scene: &Scene, state: &State) -> f64 {
    norm(part_across(
        main_direction(scene, state),
        prescribed(scene, state),
    ))
}

/// What of a force is across a direction.
fn part_across(along: Vec3, force: Vec3) -> Vec3 {
    sub(force, scale(along, dot(force, along)))
}

/// The force of an interface across the load, where there is one. Where no strip is known to be resolved it is as good as
/// that of a strip of one node to either side.
///
/// Its `course` ends with what it is now.
///
/// A surface of radius R turns by x/R where its force moves by x. Nodes further apart than the strip is wide place
/// that force no better than to a share of their distance; two nodes and more to a half-width place it well. A mesh that
/// is too stiff bends too little, and a surface that bends less is turned less along its line: a travel missed is an angle
/// missed of about that travel over half of the line.
fn horizontal_force(
    interface: &Interface,
    line: Option<&HeaviestLine>,
    (missed_travel, too_stiff, turns, course): (Option<f64>, f64, f64, Vec<Vec3>),
) -> Option<Figure> {
    /// Of the force along the load, what counts as none.
    const NONE: f64 = 1e-6;
    let across = course.last().map_or(0.0, |last| norm(*last));
    let start = [[0.0; 3]];
    let changes = start.iter().chain(&course).zip(&course);
    let changes: f64 = changes.map(|(one, next)| norm(sub(*next, *one))).sum();
    let strip = line.filter(|line| line.contact.is_some());
    let coarseness = strip.map_or(1.0, |line| {
        let strip = &line.line.heaviest;
        strip.spacing() / strip.half_width
    });
    // Pads are squeezed outwards all around: what is left of shears that all but cancel is known no better than they are. (Pads
    // on two meshes: 145.3 ± 1.0 and 159.0 ± 0.7 N without it, of a gross shear of 9.8 kN; ± 38 and ± 25 with it.)
    let settles = match strip {
        Some(_) => changes,
        None => changes.max(interface.shear_integral),
    };
    // A roller has two such places, as far apart as it is wide.
    let misplaced = 0.5 * line.map_or(0.0, turned_by_place);
    let unturned = line.map_or(0.0, |line| {
        let half_length = 0.5 * (line.line.length + line.line.lifted_off);
        missed_travel.unwrap_or(0.0) / half_length
    });
    let turned = (misplaced + unturned) * interface.normal_force.abs();
    let settles = SHEAR * coarseness * settles + OF_TURNS * turns;
    let error = Some(settles + too_stiff * changes + turned);
    let error = error.filter(|error| *error <= across);
    (across > NONE * interface.normal_force.abs()).then(|| Figure {
        error: Errors::only_of_mesh(error),
        note: error.is_none().then_some(UNKNOWN_STIFFNESS),
        ..figure_of(Quantity::HorizontalForce, &interface.name, across)
    })
}

/// Of the share by which the area of a contact may be off, that by which its friction may be: at the rim the pressure is less
/// than in the middle. (Of 5 forces of gaskets with friction that are squeezed on a part of their faces 3 were outside
/// without it, none with it.)
const OF_RIM: f64 = 0.5;

/// Adds to the error of a force across the load what the rim of its contact adds, of which the `claims` of the contact know
/// the area.
///
/// Where they do not know it, nothing is known of a force that sticks: what a mesh presses at a loaded edge is one row at every
/// size, and shears less readily the wider that row is. (Plates that bend over supports: 134, 175 and 193 N on meshes of which
/// each halves the last.) One that slides all over goes with the pressure, and one that is `given` with the load.
pub(super) fn add_rim(force: &mut Figure, claims: &[Figure], sticks: bool, given: f64) {
    /// Of itself, how far a force is from one that is the same.
    const SAME: f64 = 1e-4;
    let area = claims.iter().find(|c| c.what == Quantity::ContactArea);
    let Some(area) = area else { return };
    match (area.error.discretisation, &mut force.error.discretisation) {
        (Some(off), Some(error)) => *error += OF_RIM * off / area.value * force.value,
        (None, _) if sticks && (force.value - given).abs() > SAME * force.value => {
            force.leave_open(COARSE);
        }
        _ => {}
    }
}

/// Share of what the load of a row stands out from the straight line between those beside it that it may be off by. (Of 12
/// rollers tilted by an angle, with 7 to 13 rows, 5 were outside without it.)
const OF_SCATTER: f64 = 0.3;

/// How far from the middle of the carrier the force of a contact along lines acts, where a plane is turned by a given angle:
/// without one symmetry or statics says where.
///
/// A mesh that is too stiff by a share turns the load per length by that share too far from even, so that its force is
/// as far off. Where the line lifts off, a load that falls evenly to zero acts a third of its length from the end,
/// and that length goes with the root of the compliance: 0.84 of the share of the mean distance of loads from
/// their resultant. Loads that scatter from row to row move their resultant, too.
pub(super) fn eccentricity(
    scene: &Scene,
    interface: &Interface,
    line: Option<&HeaviestLine>,
    too_stiff: Option<f64>,
) -> Option<Figure> {
    let is_whole = |line: &&HeaviestLine| !is_mirrored(&line.frame.along, &scene.mirrors);
    let line = line.filter(is_whole)?;
    let value = line.frame.along(&interface.centre_of_force?) - line.line.middle()?;
    let spread = line.line.spread()?;
    let scatter = OF_SCATTER * line.line.scatter()?;
    let error = too_stiff.map(|share| share * value.abs().min(spread) + scatter);
    Some(Figure {
        error: Errors::only_of_mesh(error),
        note: error.is_none().then_some(UNKNOWN_STIFFNESS),
        ..figure_of(Quantity::Eccentricity, &interface.name, value)
    })
}

const UNKNOWN_FLOW: &str = "the plastic strain that makes it is not resolved";

/// Depths of dents: as good as the plastic strain of their body.
pub(super) fn dents(dents: &[(String, String, f64)], flow: &[Figure]) -> Vec<Figure> {
    let claim = |(surface, body, depth): &(String, String, f64)| {
        let strain = figure(flow, Quantity::PeakPlasticStrain, body)?;
        let error = strain
            .error
            .total()
            .map(|error| error / strain.value * depth);
        Some(Figure {
            error: Errors::only_of_mesh(error),
            note: error.is_none().then_some(UNKNOWN_FLOW),
            ..figure_of(Quantity::Dent, surface, *depth)
        })
    };
    dents.iter().filter_map(claim).collect()
}
