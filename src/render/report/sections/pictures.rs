//! Pictures of the Mises stress in section: the whole stack, and what is next to the contact.

use crate::answer::pictures::{Patch, View};
use crate::ground::geometry::AXES;
use crate::render::OutputError;
use crate::render::plot::axis::between;
use crate::render::plot::frame::Axis;
use crate::render::report::Inputs;
use crate::render::report::drawing::painting::{Label, Painting};
use crate::render::text::significant;
use maud::{Markup, html};

/// Half of the width of a close-up, in half-widths of the contact.
const CLOSE_UP_HALF_WIDTHS: f64 = 7.0;
const PICTURE_WIDTH: f64 = 420.0;

/// # Errors
/// Where a picture cannot be encoded.
pub fn pictures(inputs: &Inputs) -> Result<Markup, OutputError> {
    let mut figures = Vec::new();
    for (k, view) in inputs.pictures.views.iter().enumerate() {
        figures.push(stack(inputs, view).draw(&format!("stack{k}"))?);
        if let Some(close) = closely(inputs, view) {
            figures.push(close.draw(&format!("close{k}"))?);
        }
    }
    if figures.is_empty() {
        return Ok(Markup::default());
    }
    let note = if inputs.scene.mirrors.is_empty() {
        ""
    } else {
        " What is symmetric is drawn with its image."
    };
    Ok(html! {
        p class="note" { "Nodal averages of each body; each picture has its own scale of colours, from zero to the \
                          largest in it." (note) }
        div class="pair" { @for figure in figures { (figure) } }
    })
}

/// Where the section is, and why there.
fn why(inputs: &Inputs, view: &View) -> String {
    let (axis, at) = (AXES[view.plane.axis], significant(view.at, 3));
    match &view.contact {
        Some((interface, ..)) => {
            let length = &inputs.summary.units.length;
            format!("{axis} = {at} {length}, where {interface} carries most")
        }
        None => format!("{axis} = {at}"),
    }
}

fn stack(inputs: &Inputs, view: &View) -> Painting {
    let slices = &view.bodies;
    let corners = |k: usize| {
        let patches = slices.iter().flat_map(|(_, s)| &s.patches);
        between(patches.flat_map(|p| &p.corners).map(|c| c[k]))
    };
    let margin = |range: std::ops::Range<f64>| {
        let little = 0.03 * (range.end - range.start);
        range.start - little..range.end + little
    };
    let labels = slices.iter().map(|(name, slice)| {
        let middle = [0, 1].map(|k| {
            let corners = slice.patches.iter().flat_map(|p| &p.corners);
            let ends = between(corners.map(|c| c[k]));
            0.5 * (ends.start + ends.end)
        });
        Label {
            at: middle,
            text: name.clone(),
        }
    });
    let title = format!("Section at {}", why(inputs, view));
    let ranges = [margin(corners(0)), margin(corners(1))];
    let mut painting = painting(inputs, view, title, ranges);
    painting.labels = labels.collect();
    painting
}

fn closely(inputs: &Inputs, view: &View) -> Option<Painting> {
    let (_, [u, v], half_width) = view.contact.as_ref()?;
    let half = CLOSE_UP_HALF_WIDTHS * half_width;
    if half <= 0.0 {
        return None;
    }
    let title = "Next to the contact there".to_string();
    let ranges = [u - half..u + half, v - 0.8 * half..v + 0.8 * half];
    Some(painting(inputs, view, title, ranges))
}

fn painting(
    inputs: &Inputs,
    view: &View,
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
    let patches = view.bodies.iter().flat_map(|(_, s)| &s.patches);
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
        outlines: (view
            .bodies
            .iter()
            .flat_map(|(_, s)| s.outlines.iter().copied()))
        .collect(),
        labels: Vec::new(),
        // A tall stack is drawn narrower, lest it fill the page.
        width: (PICTURE_WIDTH / shape.max(1.0)).round(),
        shape,
        axes: [Axis::linear(name(0), x), Axis::linear(name(1), y)],
    }
}
