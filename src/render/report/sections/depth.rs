//! The Mises stress below each line of contact, against the closed form.

use super::strip::name;
use crate::answer::pictures::Strip;
use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::{Chart, Mark, Series, from_zero};
use maud::{Markup, html};

/// A diagram a line.
pub fn charts(inputs: &Inputs) -> Markup {
    let strips = &inputs.pictures.strips;
    if strips.is_empty() {
        return Markup::default();
    }
    html! {
        h3 { "Mises stress against depth" }
        p class="note" {
            "Into both bodies, square to the surface below the centre of pressure at the same place. Closed form: \
             an elastic half space in plane strain under Hertz's pressure, without friction. Where steel has \
             yielded the computed stress is capped by it."
        }
        div class="pair" { @for strip in strips { (chart(inputs, strip).draw()) } }
    }
}

fn chart(inputs: &Inputs, strip: &Strip) -> Chart {
    let units = &inputs.summary.units;
    let mut series = Vec::new();
    for (below, colour) in strip.below.iter().zip([0, 2]) {
        let Some((body, points)) = below else {
            continue;
        };
        series.push(Series {
            name: body.clone(),
            mark: Mark::LineAndDots,
            colour,
            points: points.clone(),
        });
    }
    for (ratio, points) in &strip.closed_form {
        series.push(Series {
            name: match strip.closed_form.len() {
                1 => "closed form, elastic".to_string(),
                _ => format!("closed form, elastic, ν = {ratio}"),
            },
            mark: Mark::Line,
            colour: 1,
            points: points.clone(),
        });
    }
    let largest = from_zero(series.iter().flat_map(|s| s.points.iter().map(|p| p.1)));
    Chart {
        title: name(strip, &units.length),
        axes: [
            Axis::linear(format!("depth, {}", units.length), 0.0..strip.reach),
            Axis::linear(format!("Mises stress, {}", units.stress), largest),
        ],
        series,
    }
}
