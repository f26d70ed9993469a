//! The pressure across a strip of contact, at one place along it.

use super::contact_line::ContactLine;
use super::line_frame::LineFrame;
use super::symmetry_planes::{End, SymmetryPlanes};
use crate::ground::geometry::{Vec3, dot, norm, scale, sub};
use crate::model::scene::Scene;
use crate::model::state::State;

/// The pressure of one row of nodes across a line of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct StripProfile {
    /// Coordinate of the row along the line, and its force normal to the surface per length.
    pub at: f64,
    /// Force per length of the strip.
    pub line_load: f64,
    /// Distance along the surface from the centre of pressure, ascending, and the pressure there;
    /// from the open node on one side to that on the other. The other half of a line that a plane
    /// of symmetry cuts is written out.
    pub points: Vec<(f64, f64)>,
    /// The centre of pressure on the undeformed carrier, and the unit normal that points out of it.
    pub centre: [f64; 3],
    /// Unit normal of the surface there.
    pub normal: [f64; 3],
}

/// The profile of `line`, which runs along `frame` of contact pair `pair`, at its most heavily
/// loaded row; `None` where nothing presses there.
pub fn strip_profile(
    scene: &Scene,
    state: &State,
    pair: usize,
    frame: &LineFrame,
    line: &ContactLine,
) -> Option<StripProfile> {
    let (line_load, at) = line.peak()?;
    let field = state.contacts.get(pair)?;
    let point = |i: usize| scene.mesh.points[field.nodes[i] as usize];
    let same = 1e-6 * (line.at.last()? - line.at.first()?);
    let across = |i: usize| frame.across(&point(i));
    let in_row = |i: &usize| (frame.along(&point(*i)) - at).abs() <= same;
    let off = |i: &usize| (across(*i) - line.across).abs();
    let pressing = (0..field.nodes.len()).filter(|i| in_row(i) && field.pressure[*i] > 0.0);
    let nearest = pressing.min_by(|a, b| off(a).total_cmp(&off(b)))?;
    // The node next to node `i` of the row, across a face.
    let beside = |i: usize, up: bool| {
        let faces = scene.carrier(pair)?.faces.iter();
        let around = faces.filter(|face| face.nodes.contains(&field.nodes[i]));
        let nodes = around.flat_map(|face| face.nodes);
        let mut places = nodes.filter_map(|n| field.nodes.binary_search(&n).ok());
        places.find(|k| *k != i && in_row(k) && (across(*k) > across(i)) == up)
    };
    // As far as it presses, and to the first open node on either side.
    let mut run = vec![nearest];
    for up in [false, true] {
        let mut end = nearest;
        while let Some(next) = beside(end, up).filter(|_| field.pressure[end] > 0.0) {
            run.insert(if up { run.len() } else { 0 }, next);
            end = next;
        }
    }
    let ends = [*run.first()?, *run.last()?].map(across);
    let cut = SymmetryPlanes::square_to(scene, pair, &frame.across).cut(ends[0], ends[1]);
    // From the plane that cuts it outwards.
    if let Some((End::High, _)) = cut {
        run.reverse();
    }
    let mirrored = cut.is_some();
    let run = run.as_slice();
    let mut points = along_surface(run, &point, frame, |i| field.pressure[i].max(0.0));
    let centre = if mirrored { 0.0 } else { centroid(&points) };
    let place = between(run, &points, centre, &point)?;
    points.iter_mut().for_each(|(s, _)| *s -= centre);
    if mirrored {
        let image = points.iter().skip(1).map(|(s, p)| (-s, *p));
        points = image.rev().chain(points.iter().copied()).collect();
    }
    let heaviest = run.iter().min_by(|a, b| {
        let away = |i: usize| norm(sub(point(i), place));
        away(**a).total_cmp(&away(**b))
    })?;
    let mirror = cut
        .filter(|_| Some(heaviest) == run.first())
        .map(|_| frame.across);
    Some(StripProfile {
        at,
        line_load,
        points,
        centre: place,
        normal: normal(scene, pair, field.nodes[*heaviest], (frame, mirror))?,
    })
}

/// Distance from the first node along the surface, square to the line, and the pressure.
fn along_surface(
    run: &[usize],
    point: &impl Fn(usize) -> [f64; 3],
    frame: &LineFrame,
    pressure: impl Fn(usize) -> f64,
) -> Vec<(f64, f64)> {
    let mut distance = 0.0;
    let mut before: Option<[f64; 3]> = None;
    let step = |i: &usize| {
        let here = point(*i);
        if let Some(before) = before {
            distance += norm(frame.square(sub(here, before)));
        }
        before = Some(here);
        (distance, pressure(*i))
    };
    run.iter().map(step).collect()
}

/// Centre of a pressure that is straight between its points.
fn centroid(points: &[(f64, f64)]) -> f64 {
    let (mut force, mut moment) = (0.0, 0.0);
    for pair in points.windows(2) {
        let ((a, p), (b, q)) = (pair[0], pair[1]);
        force += 0.5 * (b - a) * (p + q);
        moment += (b - a) / 6.0 * (p * (2.0 * a + b) + q * (a + 2.0 * b));
    }
    if force > 0.0 { moment / force } else { 0.0 }
}

/// The place at distance `s` along the nodes of a row.
fn between(
    run: &[usize],
    points: &[(f64, f64)],
    s: f64,
    point: &impl Fn(usize) -> [f64; 3],
) -> Option<[f64; 3]> {
    let next = points.partition_point(|(at, _)| *at < s).max(1);
    let (Some(a), Some(b)) = (points.get(next - 1), points.get(next)) else {
        return run.last().map(|i| point(*i));
    };
    let share = (s - a.0) / (b.0 - a.0);
    let (from, to) = (point(run[next - 1]), point(run[next]));
    Some([0, 1, 2].map(|k| from[k] + share * (to[k] - from[k])))
}

/// Unit normal of the carrier at `node`, square to the line and to the normal of the plane of symmetry through it.
fn normal(
    scene: &Scene,
    pair: usize,
    node: u32,
    (frame, mirror): (&LineFrame, Option<Vec3>),
) -> Option<[f64; 3]> {
    let mut sum = frame.square(scene.carrier(pair)?.area_vector_at(&scene.mesh, node));
    if let Some(mirror) = mirror {
        sum = sub(sum, scale(mirror, dot(mirror, sum)));
    }
    let length = norm(sum);
    (length > 0.0).then(|| sum.map(|c| c / length))
}
