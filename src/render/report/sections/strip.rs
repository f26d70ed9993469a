//! The pressure across each line of contact where it carries most, against Hertz.

use crate::answer::pictures::StripPicture;
use crate::render::plot::{Line, Panel, PlotFigure, Scale, charts};
use crate::render::report::Inputs;
use crate::render::text::significant;
use maud::{Markup, html};

/// Such as "upper_plate-upper_roller, line at x = 0 in, at y = 4 in".
pub(super) fn name(strip: &StripPicture, length: &str) -> String {
    let row = significant(strip.profile.at, 3);
    let along = &strip.direction;
    let across = significant(strip.across, 3);
    format!(
        "{}, line at {across} {length}, where {along} = {row} {length}",
        strip.interface
    )
}

/// Pressures, a diagram a line.
pub fn pressures(inputs: &Inputs) -> Markup {
    let note = "Across each line where it carries most, along the surface from the centre of pressure. Hertz: an \
                elastic half space under the same load per length there.";
    diagrams(inputs, "Pressure across the strip", note, figure)
}

/// A diagram of each line of contact below a heading; nothing where there are no lines.
pub fn diagrams(
    inputs: &Inputs,
    heading: &str,
    note: &str,
    figure: fn(&Inputs, &StripPicture) -> PlotFigure,
) -> Markup {
    let strips = &inputs.pictures.strips;
    if strips.is_empty() {
        return Markup::default();
    }
    let figures: Vec<PlotFigure> = strips.iter().map(|strip| figure(inputs, strip)).collect();
    html! {
        h3 { (heading) }
        p class="note" { (note) }
        (charts(&figures))
    }
}

fn figure(inputs: &Inputs, strip: &StripPicture) -> PlotFigure {
    let units = &inputs.summary.units;
    let computed = strip.profile.points.clone();
    let largest = computed.iter().map(|p| p.1).fold(0.0, f64::max);
    let load = significant(strip.profile.line_load, 4);
    let mut legend = vec![format!(
        "computed, nodes: p max {} {}, half-width {} {}",
        significant(largest, 4),
        units.stress,
        significant(strip.half_width, 3),
        units.length
    )];
    let mut lines = vec![Line::dotted(0, computed)];
    if let Some(hertz) = &strip.hertz {
        legend.push(format!(
            "Hertz for {load} {}: p0 {} {}, a {} {}",
            units.line_load(),
            significant(hertz.peak_pressure, 4),
            units.stress,
            significant(hertz.half_width, 3),
            units.length
        ));
        lines.push(Line::smooth(1, strip.ellipse.clone()));
    }
    let axes = [
        format!("distance from the centre, {}", units.length),
        format!("pressure, {}", units.stress),
    ];
    let panel = Panel::new(name(strip, &units.length), axes, Scale::Linear, lines);
    PlotFigure::single(panel, legend)
}
