//! The Mises stress below each line of contact, against the closed form.

use super::strip::name;
use crate::answer::pictures::StripPicture;
use crate::render::plot::{Line, Panel, PlotFigure, Scale, charts};
use crate::render::report::Inputs;
use maud::{Markup, html};

/// A diagram a line.
pub fn stresses(inputs: &Inputs) -> Markup {
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
        (charts(&strips.iter().map(|strip| figure(inputs, strip)).collect::<Vec<_>>()))
    }
}

fn figure(inputs: &Inputs, strip: &StripPicture) -> PlotFigure {
    let units = &inputs.summary.units;
    let (mut lines, mut legend) = (Vec::new(), Vec::new());
    for (body, points) in strip.below.iter().flatten() {
        lines.push(Line::dotted(legend.len(), points.clone()));
        legend.push(body.clone());
    }
    for (ratio, points) in &strip.closed_form {
        lines.push(Line::smooth(legend.len(), points.clone()));
        legend.push(match strip.closed_form.len() {
            1 => "closed form, elastic".to_string(),
            _ => format!("closed form, elastic, ν = {ratio}"),
        });
    }
    let panel = Panel {
        title: name(strip, &units.length),
        axes: [
            format!("depth, {}", units.length),
            format!("Mises stress, {}", units.stress),
        ],
        scale: Scale::Linear,
        lines,
        dashed: Vec::new(),
    };
    PlotFigure::single(panel, legend)
}
