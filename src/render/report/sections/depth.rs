//! The Mises stress below each line of contact, against the closed form.

use super::strip::{diagrams, name};
use crate::answer::pictures::StripPicture;
use crate::render::plot::{Line, Panel, PlotFigure, Scale};
use crate::render::report::Inputs;
use maud::Markup;

/// A diagram a line.
pub fn stresses(inputs: &Inputs) -> Markup {
    let note = "Into both bodies, square to the surface below the centre of pressure at the same place. Closed form: \
                an elastic half space in plane strain under Hertz's pressure, without friction. Where steel has \
                yielded the computed stress is capped by it.";
    diagrams(inputs, "Mises stress against depth", note, figure)
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
    let axes = [
        format!("depth, {}", units.length),
        format!("Mises stress, {}", units.stress),
    ];
    let panel = Panel::new(name(strip, &units.length), axes, Scale::Linear, lines);
    PlotFigure::single(panel, legend)
}
