//! Sections through the bodies that are worth a look.

use super::section::{Plane, Section};
use super::strip::StripPicture;
use crate::answer::Answer;
use crate::answer::results::line_frame::axis_of;
use crate::answer::results::load::upright;
use crate::answer::results::recovery::Recovered;
use crate::model::mesh::Body;
use crate::model::scene::Scene;

/// A plane, what it cuts of each body, and the contact in it that is looked at closely.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    pub plane: Plane,
    /// The coordinate of the plane as a reader is told it.
    pub at: f64,
    /// The interface that carries most there, its place in the plane and its half-width.
    pub contact: Option<(String, [f64; 2], f64)>,
    /// Every body that the plane cuts, with its image where a mirror plane stands across the page.
    pub bodies: Vec<(String, Section)>,
}

/// Square to each direction in which lines of contact run, where one carries most; without lines,
/// through the largest pressure, or the largest stress.
pub fn views(
    (scene, recovered): (&Scene, &Recovered),
    answer: &Answer,
    strips: &[StripPicture],
) -> Vec<View> {
    let up = upright(scene);
    let view = |axis: usize, at: f64| {
        let along = 3 - axis - up;
        let plane = inside(scene, axis, at, [along, up]);
        View {
            bodies: sections(scene, recovered, &plane),
            plane,
            at,
            contact: None,
        }
    };
    let mut views = Vec::new();
    for axis in (0..3).filter(|axis| *axis != up) {
        let of_axis = (strips.iter()).filter(|strip| axis_of(&strip.frame.along) == Some(axis));
        let heaviest = of_axis.max_by(|a, b| a.profile.line_load.total_cmp(&b.profile.line_load));
        if let Some(strip) = heaviest {
            let view = view(axis, strip.profile.at);
            let place = view.plane.drawn.map(|k| strip.profile.centre[k]);
            views.push(View {
                contact: Some((strip.interface.clone(), place, strip.half_width)),
                ..view
            });
        }
    }
    if views.is_empty() {
        let axis = (up + 1) % 3;
        views.extend(hottest(answer).map(|at| view(axis, at[axis])));
    }
    views
}

fn hottest(answer: &Answer) -> Option<[f64; 3]> {
    let interfaces = answer.interfaces.0.iter();
    let pressed = interfaces.max_by(|a, b| a.1.max_pressure.total_cmp(&b.1.max_pressure));
    let largest = |v: Option<f64>| v.unwrap_or(0.0);
    let bodies = answer.bodies.0.iter();
    let stressed =
        bodies.max_by(|a, b| largest(a.1.mises_max.nodal).total_cmp(&largest(b.1.mises_max.nodal)));
    pressed
        .and_then(|(_, i)| i.max_pressure_at)
        .or_else(|| stressed.and_then(|(_, b)| b.at.nodal))
}

/// The plane at `at`, moved a little inwards where it would only touch the end of a body.
fn inside(scene: &Scene, axis: usize, at: f64, drawn: [usize; 2]) -> Plane {
    let [low, high] = scene.mesh.range_along(axis);
    let (middle, little) = (0.5 * (low + high), 1e-5 * (high - low));
    Plane {
        axis,
        at: at + little * (middle - at).signum(),
        drawn,
    }
}

fn sections(scene: &Scene, recovered: &Recovered, plane: &Plane) -> Vec<(String, Section)> {
    let mesh = &scene.mesh;
    let mirrored = scene.mirrors.contains(&plane.drawn[0]);
    let cut = |(body, part): (usize, &Body)| {
        let section = plane.cut(mesh, recovered, body);
        let section = if mirrored {
            section.mirrored()
        } else {
            section
        };
        (part.name.clone(), section)
    };
    let all = mesh.bodies.iter().enumerate().map(cut);
    all.filter(|(_, section)| !section.patches.is_empty())
        .collect()
}
