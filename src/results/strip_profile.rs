//! The pressure across a strip of contact, at one place along it.

use super::State;
use super::contact_lines::{ContactLine, across};
use super::edges::carrier;
use super::quad::{area_vector, norm, sub};
use crate::scene::Scene;

/// The pressure of one row of nodes across a line of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct StripProfile {
    /// Coordinate of the row along the line, and its force normal to the surface per length.
    pub at: f64,
    pub line_load: f64,
    /// Distance along the surface from the centre of pressure, ascending, and the pressure there;
    /// from the open node on one side to that on the other. The other half of a line that a mirror
    /// plane cuts is written out.
    pub points: Vec<(f64, f64)>,
    /// The centre of pressure on the undeformed carrier, and the unit normal that points out of it.
    pub centre: [f64; 3],
    pub normal: [f64; 3],
}

/// The profile of `line`, which runs along `axis` of contact pair `pair`, at its most heavily
/// loaded row; `None` where nothing presses there.
pub fn strip_profile(
    scene: &Scene,
    state: &State,
    pair: usize,
    axis: usize,
    line: &ContactLine,
) -> Option<StripProfile> {
    let (line_load, at) = line.peak()?;
    let across = across(scene, axis)?;
    let field = state.contacts.get(pair)?;
    let point = |i: usize| scene.mesh.points[field.nodes[i] as usize];
    let same = 1e-6 * (line.at.last()? - line.at.first()?);
    let here = |i: &usize| (point(*i)[axis] - at).abs() <= same && field.gap[*i].is_finite();
    let mut row: Vec<usize> = (0..field.nodes.len()).filter(here).collect();
    row.sort_by(|a, b| point(*a)[across].total_cmp(&point(*b)[across]));
    let presses = |k: usize| row.get(k).is_some_and(|i| field.pressure[*i] > 0.0);
    let off = |k: &usize| (point(row[*k])[across] - line.across).abs();
    let pressing = (0..row.len()).filter(|k| presses(*k));
    let nearest = pressing.min_by(|a, b| off(a).total_cmp(&off(b)))?;
    let (mut first, mut last) = (nearest, nearest);
    while first > 0 && presses(first - 1) {
        first -= 1;
    }
    while presses(last + 1) {
        last += 1;
    }
    let mirrored = scene.mirrors.contains(&across) && point(row[first])[across].abs() <= same;
    let run = &row[first.saturating_sub(1)..(last + 2).min(row.len())];
    let mut points = along_surface(run, &point, axis, |i| field.pressure[i].max(0.0));
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
    Some(StripProfile {
        at,
        line_load,
        points,
        centre: place,
        normal: normal(scene, pair, field.nodes[*heaviest], axis)?,
    })
}

/// Distance from the first node along the surface, square to `axis`, and the pressure.
fn along_surface(
    run: &[usize],
    point: &impl Fn(usize) -> [f64; 3],
    axis: usize,
    pressure: impl Fn(usize) -> f64,
) -> Vec<(f64, f64)> {
    let mut distance = 0.0;
    let mut before: Option<[f64; 3]> = None;
    let step = |i: &usize| {
        let here = point(*i);
        if let Some(before) = before {
            let mut step = sub(here, before);
            step[axis] = 0.0;
            distance += norm(step);
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
    match force > 0.0 {
        true => moment / force,
        false => 0.0,
    }
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

/// Unit normal of the carrier at `node`, square to `axis` and to the mirror planes through it.
fn normal(scene: &Scene, pair: usize, node: u32, axis: usize) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    let faces = carrier(scene, pair)?.faces.iter();
    for face in faces.filter(|face| face.nodes.contains(&node)) {
        let vector = area_vector(&face.corners(&scene.mesh));
        for (s, v) in sum.iter_mut().zip(vector) {
            *s += v;
        }
    }
    sum[axis] = 0.0;
    for mirror in scene.mirrors_through(&scene.mesh.points[node as usize]) {
        sum[mirror] = 0.0;
    }
    let length = norm(sum);
    (length > 0.0).then(|| sum.map(|c| c / length))
}
