//! Pictures of the Mises stress in section: the whole stack, and what is next to the contact.

use super::strip::Line;
use crate::answer::results::load::upright;
use crate::ground::geometry::AXES;
use crate::render::OutputError;
use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::extent;
use crate::render::report::drawing::painting::{Label, Painting, Patch};
use crate::render::report::model::slice::{Plane, Slice};
use crate::render::text::significant;
use maud::{Markup, html};

/// Half of the width of a close-up, in half-widths of the contact.
const CLOSE: f64 = 7.0;
const WIDTH: f64 = 420.0;

/// A plane that is drawn, and the contact in it that is looked at closely.
struct View {
    plane: Plane,
    close: Option<([f64; 2], f64)>,
    why: String,
}

/// # Errors
/// Where a picture cannot be encoded.
pub fn pictures(inputs: &Inputs, lines: &[Line]) -> Result<Markup, OutputError> {
    let mut figures = Vec::new();
    for (k, view) in views(inputs, lines).iter().enumerate() {
        let slices = slices(inputs, view);
        figures.push(stack(inputs, view, &slices).draw(&format!("stack{k}"))?);
        if let Some(close) = closely(inputs, view, &slices) {
            figures.push(close.draw(&format!("close{k}"))?);
        }
    }
    if figures.is_empty() {
        return Ok(Markup::default());
    }
    let note = match inputs.scene.mirrors.is_empty() {
        true => "",
        false => " What is symmetric is drawn with its image.",
    };
    Ok(html! {
        p class="note" { "Nodal averages of each body; each picture has its own scale of colours, from zero to the \
                          largest in it." (note) }
        div class="pair" { @for figure in figures { (figure) } }
    })
}

/// Square to each direction in which lines of contact run, where one carries most; without lines,
/// through the largest pressure, or the largest stress.
fn views(inputs: &Inputs, lines: &[Line]) -> Vec<View> {
    let up = upright(inputs.scene);
    let mut views = Vec::new();
    for axis in (0..3).filter(|axis| *axis != up) {
        let along = 3 - axis - up;
        let of_axis = lines.iter().filter(|line| line.axis == axis);
        let heaviest = of_axis.max_by(|a, b| a.profile.line_load.total_cmp(&b.profile.line_load));
        let length = &inputs.summary.units.length;
        if let Some(line) = heaviest {
            let centre = line.profile.centre;
            views.push(View {
                plane: inside(inputs, axis, line.profile.at, [along, up]),
                close: Some(([centre[along], centre[up]], CLOSE * line.half_width)),
                why: format!(
                    "{} = {} {length}, where {} carries most",
                    AXES[axis],
                    significant(line.profile.at, 3),
                    line.interface
                ),
            });
        }
    }
    if !views.is_empty() {
        return views;
    }
    let Some(at) = hottest(inputs) else {
        return views;
    };
    let axis = (up + 1) % 3;
    let along = 3 - axis - up;
    views.push(View {
        plane: inside(inputs, axis, at[axis], [along, up]),
        close: None,
        why: format!("{} = {}", AXES[axis], significant(at[axis], 3)),
    });
    views
}

fn hottest(inputs: &Inputs) -> Option<[f64; 3]> {
    let interfaces = inputs.summary.answer.interfaces.0.iter();
    let pressed = interfaces.max_by(|a, b| a.1.max_pressure.total_cmp(&b.1.max_pressure));
    let largest = |v: Option<f64>| v.unwrap_or(0.0);
    let bodies = inputs.summary.answer.bodies.0.iter();
    let stressed =
        bodies.max_by(|a, b| largest(a.1.mises_max.nodal).total_cmp(&largest(b.1.mises_max.nodal)));
    pressed
        .and_then(|(_, i)| i.max_pressure_at)
        .or_else(|| stressed.and_then(|(_, b)| b.at.nodal))
}

/// The plane at `at`, moved a little inwards where it would only touch the end of a body.
fn inside(inputs: &Inputs, axis: usize, at: f64, drawn: [usize; 2]) -> Plane {
    let ends = extent(inputs.scene.mesh.points.iter().map(|p| p[axis]));
    let (middle, little) = (
        0.5 * (ends.start + ends.end),
        1e-5 * (ends.end - ends.start),
    );
    Plane {
        axis,
        at: at + little * (middle - at).signum(),
        drawn,
    }
}

fn slices(inputs: &Inputs, view: &View) -> Vec<(String, Slice)> {
    let mesh = &inputs.scene.mesh;
    let mirrored = inputs.scene.mirrors.contains(&view.plane.drawn[0]);
    let cut = |(body, part): (usize, &crate::model::mesh::Body)| {
        let slice = view.plane.cut(mesh, inputs.recovered, body);
        let slice = if mirrored { slice.mirrored() } else { slice };
        (part.name.clone(), slice)
    };
    let all = mesh.bodies.iter().enumerate().map(cut);
    all.filter(|(_, slice)| !slice.patches.is_empty()).collect()
}

fn stack(inputs: &Inputs, view: &View, slices: &[(String, Slice)]) -> Painting {
    let corners = |k: usize| {
        let patches = slices.iter().flat_map(|(_, s)| &s.patches);
        extent(patches.flat_map(|p| &p.corners).map(|c| c[k]))
    };
    let margin = |range: std::ops::Range<f64>| {
        let little = 0.03 * (range.end - range.start);
        range.start - little..range.end + little
    };
    let labels = slices.iter().map(|(name, slice)| {
        let middle = [0, 1].map(|k| {
            let corners = slice.patches.iter().flat_map(|p| &p.corners);
            let ends = extent(corners.map(|c| c[k]));
            0.5 * (ends.start + ends.end)
        });
        Label {
            at: middle,
            text: name.clone(),
        }
    });
    let title = format!("Section at {}", view.why);
    let ranges = [margin(corners(0)), margin(corners(1))];
    let mut painting = painting(inputs, view, slices, title, ranges);
    painting.labels = labels.collect();
    painting
}

fn closely(inputs: &Inputs, view: &View, slices: &[(String, Slice)]) -> Option<Painting> {
    let ([u, v], half) = view.close?;
    if half <= 0.0 {
        return None;
    }
    let title = "Next to the contact there".to_string();
    let ranges = [u - half..u + half, v - 0.8 * half..v + 0.8 * half];
    Some(painting(inputs, view, slices, title, ranges))
}

fn painting(
    inputs: &Inputs,
    view: &View,
    slices: &[(String, Slice)],
    title: String,
    [x, y]: [std::ops::Range<f64>; 2],
) -> Painting {
    let units = &inputs.summary.units;
    let seen = |patch: &&Patch| {
        let beyond = |k: usize, range: &std::ops::Range<f64>| {
            patch.corners.iter().all(|c| c[k] < range.start)
                || patch.corners.iter().all(|c| c[k] > range.end)
        };
        !beyond(0, &x) && !beyond(1, &y)
    };
    let patches = slices.iter().flat_map(|(_, s)| &s.patches);
    let patches: Vec<Patch> = patches.filter(seen).cloned().collect();
    let values = patches.iter().flat_map(|p| p.values.iter().copied());
    let largest = values.fold(0.0, f64::max);
    let name = |k: usize| format!("{}, {}", AXES[view.plane.drawn[k]], units.length);
    let shape = (y.end - y.start) / (x.end - x.start);
    Painting {
        title,
        quantity: format!("Mises stress, {}", units.stress),
        largest: if largest > 0.0 { largest } else { 1.0 },
        patches,
        outlines: (slices.iter().flat_map(|(_, s)| s.outlines.iter().copied())).collect(),
        labels: Vec::new(),
        // A tall stack is drawn narrower, lest it fill the page.
        width: (WIDTH / shape.max(1.0)).round(),
        shape,
        axes: [Axis::linear(name(0), x), Axis::linear(name(1), y)],
    }
}
