//! The pressure on the carrier surface of every interface, seen along the load.

use crate::answer::results::edges::carrier;
use crate::answer::results::line_load::Slices;
use crate::answer::results::load::upright;
use crate::ground::geometry::AXES;
use crate::render::OutputError;
use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::extent;
use crate::render::report::drawing::painting::{Painting, Patch};
use crate::render::text::significant;
use maud::{Markup, html};
use std::ops::Range;

const WIDTH: f64 = 480.0;
/// Least and largest height over width of a map; a strip is stretched across.
const SHAPES: [f64; 2] = [0.3, 1.0];

/// # Errors
/// Where a picture cannot be encoded.
pub fn maps(inputs: &Inputs) -> Result<Markup, OutputError> {
    let mut figures = Vec::new();
    for pair in 0..inputs.scene.contacts.len() {
        if let Some(map) = map(inputs, pair) {
            figures.push(map.draw(&format!("pressure{pair}"))?);
        }
    }
    if figures.is_empty() {
        return Ok(Markup::default());
    }
    Ok(html! { div class="pair" { @for figure in figures { (figure) } } })
}

fn map(inputs: &Inputs, pair: usize) -> Option<Painting> {
    let (scene, units) = (inputs.scene, &inputs.summary.units);
    let up = upright(inputs.scene);
    let along = Slices::equal(scene, pair, 1).map_or((up + 1) % 3, |s| s.axis);
    if along == up {
        return None;
    }
    let drawn = [along, 3 - along - up];
    let patches = patches(inputs, pair, drawn)?;
    let pressed = || patches.iter().filter(|p| p.values.iter().any(|v| *v > 0.0));
    let range = |k: usize| {
        let range = extent(pressed().flat_map(|p| &p.corners).map(|c| c[k]));
        let little = 0.04 * (range.end - range.start);
        range.start - little..range.end + little
    };
    let ranges: [Range<f64>; 2] = [range(0), range(1)];
    let [width, height] = [&ranges[0], &ranges[1]].map(|r| r.end - r.start);
    let shape = (height / width).clamp(SHAPES[0], SHAPES[1]);
    let stretched = shape / (height / width);
    let stretch = match (stretched - 1.0).abs() > 0.01 {
        true => format!(
            ", drawn {} times as wide as it is",
            significant(stretched, 2)
        ),
        false => String::new(),
    };
    let largest = pressed()
        .flat_map(|p| p.values.iter().copied())
        .fold(0.0, f64::max);
    let name = |k: usize| format!("{}, {}", AXES[drawn[k]], units.length);
    let [x, y] = ranges;
    Some(Painting {
        title: format!("{}{stretch}", scene.contacts[pair].name),
        quantity: format!("pressure, {}", units.stress),
        largest,
        outlines: Vec::new(),
        labels: Vec::new(),
        shape,
        width: WIDTH,
        axes: [Axis::linear(name(0), x), Axis::linear(name(1), y)],
        patches,
    })
}

/// The faces that see the other side, with their images in the mirror planes; `None` where nothing
/// presses.
fn patches(inputs: &Inputs, pair: usize, drawn: [usize; 2]) -> Option<Vec<Patch>> {
    let (scene, field) = (inputs.scene, inputs.state.contacts.get(pair)?);
    let node = |n: u32| field.nodes.binary_search(&n).ok();
    let mut patches = Vec::new();
    for face in &carrier(scene, pair)?.faces {
        let nodes = face.nodes.map(node);
        let sees = |i: &Option<usize>| i.is_some_and(|i| field.gap[i].is_finite());
        if !nodes.iter().any(sees) {
            continue;
        }
        let corners = face.corners(&scene.mesh).map(|p| drawn.map(|k| p[k]));
        let values = nodes.map(|i| i.map_or(0.0, |i| field.pressure[i].max(0.0)));
        patches.push(Patch {
            corners: corners.to_vec(),
            values: values.to_vec(),
        });
    }
    for (k, axis) in drawn.iter().enumerate() {
        if scene.mirrors.contains(axis) {
            let images: Vec<Patch> = patches.iter().map(|p| p.image(k)).collect();
            patches.extend(images);
        }
    }
    let presses = |p: &Patch| p.values.iter().any(|v| *v > 0.0);
    patches.iter().any(presses).then_some(patches)
}
