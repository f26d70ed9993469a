//! Peak stress and strain of bodies.

use super::at_bore::AtBore;
use super::below_patches::BelowPatches;
use super::earlier::Earlier;
use super::figure::{Errors, Figure, Quantity, figure, figure_of};
use super::half_spaces::{FromStrip, HalfSpaces};
use super::notes::LONG_FACES;
use super::plastic_strain::plastic_strain;
use super::strip_below::StripBelow;
use crate::answer::results::curvature::Curvature;
use crate::answer::results::edges::ByEdge;
use crate::answer::results::peaks::Place;
use crate::answer::results::peaks::{BodyPeaks, MisesPeaks};

const YIELDED: &str = "yielded: the Mises stress is held by the yield limit and says nothing of the \
                       mesh; look at the elastic peak and the plastic strain";

const OF_TWIN: &str = "of the elastic solution, on a mesh of its own";

const SINGULAR: &str = "at a singular edge (loaded or held, an inner corner, the rim of what is joined), or where a fillet is \
                        not resolved: grows with every refinement until the steel yields";

const EXCEEDED: &str = "a finer mesh may show a larger one at a loaded edge";

const AS_LARGE: &str = "the error may be as large as the stress itself";
const COARSE: &str = "below a strip or patch of contact that the nodes are too far apart for: there is no peak to be read";

const BY_HALF_SPACES: &str = "as the half spaces below the strips make it under their loads per length, with what else acts in the body a \
                              few half-widths away; the nodes there are too far apart to show it";

const STEEP: &str = "the stress falls by more than half within one element: the elements are too large for the hole, fillet \
                     or wall that makes the peak";

/// Share of itself by which a stress may fall from the node of its peak to another of the same elements. (At the bores of tubes
/// with 67 to 84 % the peak was read 27 to 42 % too small, with 47 % 11 to 15 % and within its bar.)
const MOST_FALL: f64 = 0.5;

/// What nodal averages miss of a peak that lies between nodes, at most, of itself,
const SMOOTH: f64 = 0.02;
/// and of the fall from the peak to the smallest nodal value of the elements around it: of a parabola with its peak in the
/// middle of an element it is a 24th. Four times that.
const OF_FALL: f64 = 1.0 / 6.0;

/// Facets in a half-width from which on the peak that is read counts for more than that of a half space.
const FINE: f64 = 3.0;

/// Share of the overshoot that is taken off: the stresses of B-bar at integration points are themselves a little below. On
/// problem H 0.7 to 0.9 with two to eight facets in a half-width, below the strips of bearings 0.75 in the middle.
const OF_OVERSHOOT: f64 = 0.75;

/// Share of the bar that is left where the peak is corrected. The share that 95 of 100 peaks of bearings need.
const OF_BAR: f64 = 0.6;

/// Of a peak on a surface that presses, as at the rim of a flat pad: nodal average, centre and integration points are all below
/// it. (Of 78 peaks below flat pads 10 were outside without it, 4 with it.)
const AT_SURFACE: f64 = 2.0;

/// Where no strip is above, share of the distance between the nodal value and what the means of elements tend to at the node:
/// at a surface that is of the first order of the spacing, as the error is, and the other differences may miss it. (Of 772
/// peaks of 204 drawn scenes with holes, fillets, bores, press fits and ties 158 were outside without it.)
const OF_MEANS: f64 = 2.0;

/// What bodies of finite size and a strip beside add to the largest stress below a strip, of itself.
const BODIES: f64 = 0.03;

/// Share of the distance between the largest value at an integration point and the nodal one.
const OVERSHOOT: f64 = 0.5;

/// Share of the distance between the largest stress that an element extrapolates to the node of the peak and the
/// average there. Elements that differ that much do not resolve the stress between them, as beside the region of
/// a loaded edge. The share that 95 of 100 peaks of bearings need (docs/coverage.md).
const JUMP: f64 = 0.35;

/// Of the peak below half spaces, what an edge next to it may add or take.
const NEXT_TO_EDGE: f64 = 0.06;

/// Of a peak next to what belongs to a loaded edge, share of what the largest stress there is above it, and of the jump: the
/// node may lie an element away from where that ends, and takes part in what its elements make of the edge. (All of 114
/// peaks of sixteen bearings hold with it, of 0.35 of the jump 95 in 100.)
const BESIDE: f64 = 0.5;

/// Peak Mises stress of every body; where it has yielded also its peak plastic strain and the peak
/// of the elastic solution.
///
/// The nodal peak is claimed; below a strip that the mesh resolves, less what extrapolation overshoots by. It and
/// that of element centres tend to the same value from different sides of the error: extrapolation to nodes
/// overshoots by the curvature of the stress over an element, while a centre lies close to it; the largest value at
/// an integration point overshoots most; the elements that meet at a node differ by what none of them resolves; slopes from
/// element to element say something else at the node than slopes within them. These
/// differences are the
/// estimate, the largest of them; below a point of contact the first counts the less the better its pressure is known, and the
/// stress is not known better than that. Beside a loaded edge there is none, and the peak away
/// from such edges is claimed, too; where it lies next to what is left out, the stress there counts in place of that of
/// element centres.
///
/// Below a Hertzian strip the half space says how large the peak is, within what the bodies add to it:
/// the distance from that is an error, too, less of it on finer grids (all of it where elements are no grid: of 876 peaks below
/// strips on unstructured meshes, drawn by a seed, 208 were outside of their bars otherwise); with a node and less in a half-width there is no peak
/// to be read at all: neither that below the strip, nor a smaller one elsewhere.
pub(super) fn claims(
    (own, earlier): (&[BodyPeaks], &[Earlier]),
    (elastic, of_finer): (Option<&[BodyPeaks]>, &[Figure]),
    (strips, below, facets, travel_off): (&[StripBelow<'_>], &BelowPatches, &[f64], f64),
    (pressures_off, bores): (&[Option<f64>], &[AtBore]),
) -> Vec<Figure> {
    let mut claims = Vec::new();
    for (index, body) in own.iter().enumerate() {
        let yielded = body.peeq_max > 0.0;
        let read = |peaks: &BodyPeaks, names, half_spaces| {
            let strips = strips.iter().filter(|strip| strip.body == index);
            let strips = strips.collect::<Vec<_>>();
            mises(
                (index, peaks),
                names,
                (&strips, below, facets[index], travel_off),
                half_spaces,
                bores.iter().find(|bore| bore.body == body.name),
            )
        };
        let mises =
            |peaks: &BodyPeaks, names| read(peaks, names, HalfSpaces::below(peaks, pressures_off));
        let names = [Quantity::PeakMises, Quantity::MisesAway];
        if !yielded {
            claims.extend(mises(body, names));
            continue;
        }
        // The half space is elastic.
        let nothing = (&[][..], &BelowPatches::default(), facets[index], 0.0);
        let mut peaks = self::mises((index, body), names, nothing, None, None);
        let left = earlier.iter().map(|end| left_of(end, (index, body)));
        let left = left.fold(0.0, f64::max);
        for claim in &mut peaks {
            claim.note = Some(YIELDED);
            if let Some(error) = &mut claim.error.discretisation {
                *error += left;
                if *error > claim.value {
                    claim.leave_open(AS_LARGE);
                }
            }
        }
        claims.extend(peaks);
        let names = [Quantity::ElasticPeakMises, Quantity::ElasticMisesAway];
        let of_body = elastic.and_then(|bodies| bodies.get(index));
        let elastic = match of_finer {
            [] => of_body.map_or_else(Vec::new, |elastic| mises(elastic, names)),
            claims => as_elastic(claims, &body.name),
        };
        // Steel flows as nodes have it, whatever half spaces know.
        let of_nodes = match of_finer {
            [] => of_body.map_or_else(Vec::new, |elastic| read(elastic, names, None)),
            _ => elastic.clone(),
        };
        let of_nodes = of_nodes
            .iter()
            .filter(|claim| claim.note != Some(BY_HALF_SPACES));
        let of_nodes: Vec<&Figure> = of_nodes.collect();
        // Where an edge does not decide what this mesh shows, the strain is that away from it.
        let decides = |claim: &&Figure| claim.is_resolved() || claim.at_edge;
        let peak = of_nodes
            .iter()
            .copied()
            .find(decides)
            .or(of_nodes.first().copied());
        claims.push(plastic_strain(body, peak));
        claims.extend(elastic);
    }
    claims
}

/// What is wrong with the stress of a body that flowed by the end of an earlier step, and has been taken off since: of what is left, the
/// difference of two states, it is an error still.
fn left_of(end: &Earlier, (index, body): (usize, &BodyPeaks)) -> f64 {
    let before = end.peaks.get(index).filter(|before| before.peeq_max > 0.0);
    let taken_off = before.and_then(|before| Some(before.nodal?.value - body.nodal?.value));
    let off = end.travel.map_or(0.0, |travel| travel.stress_off());
    off * taken_off.unwrap_or(0.0).max(0.0)
}

/// Claims of a body's Mises peaks that stayed elastic on another mesh, as those of the elastic solution.
fn as_elastic(claims: &[Figure], body: &str) -> Vec<Figure> {
    let names = [
        (Quantity::PeakMises, Quantity::ElasticPeakMises),
        (Quantity::MisesAway, Quantity::ElasticMisesAway),
    ];
    let renamed = |(own, elastic): (Quantity, Quantity)| {
        let mut claim = figure(claims, own, body)?.clone();
        claim.what = elastic;
        claim.note.get_or_insert(OF_TWIN);
        Some(claim)
    };
    names.into_iter().filter_map(renamed).collect()
}

/// The nodal peak of a body, and that away from loaded edges where it lies at one.
fn mises(
    (index, body): (usize, &BodyPeaks),
    [peak, away]: [Quantity; 2],
    (strips, below, facets, travel_off): (&[&StripBelow<'_>], &BelowPatches, f64, f64),
    half_spaces: Option<HalfSpaces>,
    bore: Option<&AtBore>,
) -> Vec<Figure> {
    let Some((nodal, centroid)) = body.nodal.zip(body.centroid) else {
        return Vec::new();
    };
    let is_by_edge = (body.away).is_some_and(|(by, _)| by == ByEdge::Here);
    let claim = |what: Quantity, read: MisesPeaks, at_points: f64| {
        let MisesPeaks {
            nodal,
            centroid,
            around,
            is_on_border,
        } = read;
        let is_next_to_edge = around.border > 0.0;
        let above_it = strips.iter().find(|strip| strip.is_above(&nodal.at));
        let reach = match (above_it, nodal.place) {
            (Some(strip), Place::Node(node)) => strip.reach_at(node),
            _ => 0.0,
        };
        let is_unseen = above_it.is_some_and(|strip| !strip.shows_at(reach));
        let strip = above_it.and_then(|strip| Some((*strip, strip.mises?)));
        let counts = strip.map_or_else(|| below.share(index, &nodal.at), |_| 1.0);
        let is_steep = around.fall > MOST_FALL * nodal.value && !below.is_above(index, &nodal.at);
        let above = nodal.value - centroid.value;
        // The centres that count are then farther from the edge than the node is.
        let spread = match is_next_to_edge {
            true => BESIDE * around.jump,
            false => (counts * above)
                .max(-above)
                .max(OVERSHOOT * at_points)
                .max(JUMP * around.jump),
        };
        let share = strip.map_or(1.0, |(strip, _)| strip.share(&nodal.at));
        // Elsewhere away from a loaded edge it matters more how near to it nodes lie.
        let corrected = strip
            .filter(|_| !is_by_edge || is_on_border)
            .map_or(0.0, |(strip, _)| strip.resolves(share, reach));
        let Curvature { overshoot, vertex } = around.curvature;
        let value = nodal.value + corrected * (vertex - OF_OVERSHOOT * overshoot);
        let left = 1.0 - corrected * (1.0 - OF_BAR);
        let (error, note) = match strip {
            _ if is_unseen => (None, Some(COARSE)),
            None if is_steep => (None, Some(STEEP)),
            _ if around.rises_to_long_faces => (None, Some(LONG_FACES)),
            _ if is_next_to_edge => {
                let means = strip.map_or(OF_MEANS * around.means, |_| 0.0);
                let overshoot = (1.0 - corrected) * overshoot.max(0.0);
                (Some(spread + means + overshoot), None)
            }
            Some((strip, of_half_space)) => {
                // The finer the mesh, the more is what it says worth beside the half space: its error is of second
                // order.
                let weight = (FINE * strip.widest(reach) / (share * strip.half_width))
                    .min(1.0)
                    .powi(2);
                let mises = share * of_half_space;
                let [weight, left] = match around.is_irregular {
                    true => [1.0; 2],
                    false => [weight, left],
                };
                let off = (nodal.value - mises).abs() + BODIES * mises;
                let load = 0.5 * strip.spread_otherwise(travel_off) * mises;
                (Some(left * spread.max(weight * off) + load), None)
            }
            None if below.hide(index, &nodal.at) => (None, Some(COARSE)),
            None => {
                let between = (OF_FALL * around.fall).min(SMOOTH * nodal.value);
                let spread = if below.press(&nodal) {
                    AT_SURFACE * spread
                } else {
                    spread
                };
                let by_mesh = spread + between + counts * OF_MEANS * around.means;
                let of_pressure = below.of_pressure(index, &nodal.at).unwrap_or(0.0);
                (Some(by_mesh.max(of_pressure * nodal.value)), None)
            }
        };
        let error = error.map(|error| error + facets * value);
        // Under the load line the bore is known from its strain: better than from nodes, or no better than that.
        let (value, error) = match bore {
            Some(bore) if bore.at == nodal.at => (bore.mises, bore.error),
            _ => (value, error),
        };
        let known = half_spaces.filter(|known| what == away || !known.at_edge);
        let place = match above_it {
            Some(strip) if strip.is_at(&nodal.at) => FromStrip::AtSurface,
            Some(_) => FromStrip::Below,
            None => FromStrip::Elsewhere,
        };
        // Of a peak elsewhere they say nothing where nodes show the stress below strips, too.
        let counts = above_it.is_some() || strips.iter().any(|strip| !strip.shows());
        let beside_edge = if is_next_to_edge { NEXT_TO_EDGE } else { 0.0 };
        let known = known.filter(|_| counts);
        if let Some((value, error)) = known.and_then(|known| {
            let known = known.with_share(facets + beside_edge);
            known.beside((value, error), place)
        }) {
            return Figure {
                error: Errors::only_of_mesh(Some(error)),
                note: known
                    .filter(|known| known.mises == value)
                    .map(|_| BY_HALF_SPACES),
                ..figure_of(what, &body.name, value)
            };
        }
        // A peak elsewhere, as on a bore, is the largest only if it is above what the mesh does not show.
        let may_hide = |most: f64| {
            let larger = |strip: &&StripBelow| strip.mises.is_some_and(|mises| mises > most);
            strips.iter().any(|strip| !strip.shows() && larger(strip))
                || below.hide_more(index, most)
        };
        let (error, note) = match error {
            Some(error) if may_hide(value + error) => (None, Some(COARSE)),
            Some(error) if error > value => (None, Some(AS_LARGE)),
            error => (error, note),
        };
        Figure {
            error: Errors {
                discretisation: error,
                beside_edge: error
                    .filter(|_| is_next_to_edge)
                    .map(|error| (BESIDE * around.border - error).max(0.0)),
                ..Errors::default()
            },
            note,
            ..figure_of(what, &body.name, value)
        }
    };
    let at_points = body
        .integration_point
        .map_or(0.0, |p| (p.value - nodal.value).abs());
    let whole = MisesPeaks {
        nodal,
        centroid,
        around: body.around,
        is_on_border: false,
    };
    match body.away {
        None => vec![claim(peak, whole, at_points)],
        Some((_, regular)) => {
            let singular = Figure {
                at_edge: is_by_edge,
                note: Some(if is_by_edge { SINGULAR } else { EXCEEDED }),
                ..figure_of(peak, &body.name, nodal.value)
            };
            vec![singular, claim(away, regular, 0.0)]
        }
    }
}
