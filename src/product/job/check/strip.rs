//! Lines of contact before the load: Hertz's half-width under an even load, and the elements across it.

use crate::analytic::DomainError;
use crate::analytic::hertz::LineContact;
use crate::answer::results::load::full;
use crate::case::Case;
use crate::ground::geometry::{Vec3, dot, norm, range, scale, sub};
use crate::model::mesh::shape::Shape;
use crate::model::scene::{ContactPair, Partner, Scene};
use crate::product::job::JobError;
use crate::render::check::StripCheck;
use crate::solver::solve::{Forecast, PairForecast};

/// The lines of `scene`: of each pair of a bearing, and of other pairs whose carrier is a cylinder on a
/// plane or along another cylinder, if that pair carries the whole load.
pub fn strips(
    case: &Case,
    scene: &Scene,
    forecast: &Forecast,
) -> Result<Vec<StripCheck>, JobError> {
    let pairs = scene.contacts.iter().zip(&forecast.pairs);
    let strips = pairs.filter_map(|(pair, found)| strip(case, scene, pair, found).transpose());
    let strips: Result<Vec<StripCheck>, DomainError> = strips.collect();
    strips.map_err(|error| JobError::ClosedForm {
        what: "the half-width of the contact".to_owned(),
        why: error.to_string(),
    })
}

/// A line along a cylinder.
struct Line {
    axis: Vec3,
    /// Effective radius, of both sides.
    radius: f64,
    /// Length in the whole.
    length: f64,
    /// How many there are, and the force normal to the surface that each takes.
    lines: usize,
    force: f64,
}

fn strip(
    case: &Case,
    scene: &Scene,
    pair: &ContactPair,
    found: &PairForecast,
) -> Result<Option<StripCheck>, DomainError> {
    let load = norm(full(scene));
    let (Some(line), Some((node, _)), true) = (line(case, scene, pair, load), found.at, load > 0.0)
    else {
        return Ok(None);
    };
    let Some(spacing) = spacing(scene, pair, node, line.axis) else {
        return Ok(None);
    };
    let load = line.force / line.length;
    let hertz = LineContact::new(load, line.radius, scene.compliance(pair)?)?;
    let elements = hertz.half_width / spacing;
    Ok(Some(StripCheck {
        contact: pair.name.clone(),
        lines: line.lines,
        line_load: hertz.line_load,
        half_width: hertz.half_width,
        peak_pressure: hertz.peak_pressure,
        spacing,
        elements,
        pressure_error: (elements > 1.0).then(|| 0.25 * elements.powi(-2)),
    }))
}

fn line(case: &Case, scene: &Scene, pair: &ContactPair, load: f64) -> Option<Line> {
    let [carrier, other] = pair.carrier_first();
    if let Some(bearing) = case.bearing() {
        let seat = bearing.seat(&pair.name)?;
        let mut axis = [0.0; 3];
        axis[seat.axis] = 1.0;
        return Some(Line {
            axis,
            radius: seat.radius,
            length: bearing.geometry.length(),
            lines: seat.lines.len(),
            force: seat.even(load),
        });
    }
    // Either side may be the cylinder, whichever carries.
    let (axis, radius, round, other) =
        [(carrier, other), (other, carrier)]
            .into_iter()
            .find_map(|(side, other)| match side.shape(&scene.mesh) {
                Shape::Cylinder {
                    axis,
                    radius,
                    convex: true,
                    ..
                } => Some((axis, radius, side, other)),
                _ => None,
            })?;
    let curvature = 1.0 / radius + other.shape(&scene.mesh).curvature(axis, 0.999)?;
    let length = length(scene, round, axis);
    (curvature > 0.0 && length > 0.0).then(|| Line {
        axis,
        radius: 1.0 / curvature,
        length,
        lines: 1,
        force: load,
    })
}

/// Extent of a surface along `axis`, in the whole.
fn length(scene: &Scene, partner: &Partner, axis: Vec3) -> f64 {
    let Some(surface) = partner.surface(&scene.mesh) else {
        return 0.0;
    };
    let nodes = surface.nodes().into_iter();
    let [low, high] = range(nodes.map(|n| dot(scene.mesh.points[n as usize], axis)));
    let mirrored = scene
        .mirrors
        .iter()
        .any(|mirror| axis[*mirror].abs() > 0.999);
    let times = if mirrored { 2.0 } else { 1.0 };
    times * (high - low)
}

/// Mean distance across `axis` of the carrier's node at first touch from its neighbours.
fn spacing(scene: &Scene, pair: &ContactPair, node: u32, axis: Vec3) -> Option<f64> {
    let mesh = &scene.mesh;
    let [carrier, _] = pair.carrier_first();
    let mut across = Vec::new();
    for face in &carrier.surface(mesh)?.faces {
        let Some(at) = face.nodes.iter().position(|n| *n == node) else {
            continue;
        };
        for neighbour in [face.nodes[(at + 1) % 4], face.nodes[(at + 3) % 4]] {
            let edge = sub(mesh.points[neighbour as usize], mesh.points[node as usize]);
            let along = dot(edge, axis);
            let aside = norm(sub(edge, scale(axis, along)));
            // An edge along the line is none across it.
            if aside > along.abs() {
                across.push(aside);
            }
        }
    }
    (!across.is_empty()).then(|| across.iter().sum::<f64>() / across.len() as f64)
}
