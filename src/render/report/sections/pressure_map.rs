//! The pressure on the carrier surface of every interface, seen along the load.

use crate::answer::pictures::PressureMap;
use crate::ground::geometry::AXES;
use crate::render::OutputError;
use crate::render::plot::axis::between;
use crate::render::plot::frame::Axis;
use crate::render::report::Inputs;
use crate::render::report::drawing::painting::Painting;
use crate::render::text::significant;
use maud::{Markup, html};
use std::ops::Range;

const MAP_WIDTH: f64 = 480.0;
/// Least and largest height over width of a map; a strip is stretched across.
const ASPECTS: [f64; 2] = [0.3, 1.0];

/// # Errors
/// Where a picture cannot be encoded.
pub fn maps(inputs: &Inputs) -> Result<Markup, OutputError> {
    let mut figures = Vec::new();
    for (k, map) in inputs.pictures.pressures.iter().enumerate() {
        figures.push(painting(inputs, map).draw(&format!("pressure{k}"))?);
    }
    if figures.is_empty() {
        return Ok(Markup::default());
    }
    Ok(html! { div class="pair" { @for figure in figures { (figure) } } })
}

fn painting(inputs: &Inputs, map: &PressureMap) -> Painting {
    let units = &inputs.summary.units;
    let (drawn, patches) = (map.drawn, &map.patches);
    let pressed = || patches.iter().filter(|p| p.values.iter().any(|v| *v > 0.0));
    let range = |k: usize| {
        let range = between(pressed().flat_map(|p| &p.corners).map(|c| c[k]));
        let little = 0.04 * (range.end - range.start);
        range.start - little..range.end + little
    };
    let ranges: [Range<f64>; 2] = [range(0), range(1)];
    let [width, height] = [&ranges[0], &ranges[1]].map(|r| r.end - r.start);
    let shape = (height / width).clamp(ASPECTS[0], ASPECTS[1]);
    let stretched = shape / (height / width);
    let stretch = if (stretched - 1.0).abs() > 0.01 {
        format!(
            ", drawn {} times as wide as it is",
            significant(stretched, 2)
        )
    } else {
        String::new()
    };
    let largest = pressed()
        .flat_map(|p| p.values.iter().copied())
        .fold(0.0, f64::max);
    let name = |k: usize| format!("{}, {}", AXES[drawn[k]], units.length);
    let [x, y] = ranges;
    Painting {
        title: format!("{}{stretch}", map.interface),
        quantity: format!("pressure, {}", units.stress),
        largest,
        outlines: Vec::new(),
        labels: Vec::new(),
        shape,
        width: MAP_WIDTH,
        axes: [Axis::linear(name(0), x), Axis::linear(name(1), y)],
        patches: patches.clone(),
    }
}
