//! Line loads as a figure.

use super::WholeLine;
use crate::ground::units::UnitLabels;
use crate::render::plot::{Line, Panel, PlotFigure, Scale};
use crate::render::text::significant;

/// A panel for each interface with a curve for each of its lines, in the order of their places
/// across, and dashed the loads of the lines spread evenly.
pub fn figure(lines: &[WholeLine], units: &UnitLabels) -> PlotFigure {
    let panels: Vec<Panel> = lines
        .chunk_by(|a, b| a.interface == b.interface)
        .map(|of| panel(of, units))
        .collect();
    let most = panels.iter().map(|p| p.lines.len()).max().unwrap_or(0);
    let name = |k: usize| match most {
        1 => "load on the line of contact".to_string(),
        _ => format!("load on line {}, by place across", k + 1),
    };
    PlotFigure {
        panels,
        legend: (0..most).map(name).collect(),
        dashed: "the same force, spread evenly over the length".to_string(),
    }
}

fn panel(lines: &[WholeLine], units: &UnitLabels) -> Panel {
    let first = lines.first();
    let axis = first.map_or("", |line| line.axis);
    let interface = first.map_or("", |line| line.interface);
    let places: Vec<String> = lines.iter().map(|l| significant(l.across, 3)).collect();
    let across = first.map_or("", |line| line.across_axis);
    let curve = |(style, line): (usize, &WholeLine)| Line::dotted(style, line.rows.clone());
    let (length, places) = (&units.length, places.join(" and "));
    Panel {
        title: format!("{interface}, at {across} = {places} {length}"),
        axes: [
            format!("{axis}, {length}"),
            format!("line load, {}", units.line_load()),
        ],
        scale: Scale::Linear,
        lines: lines.iter().enumerate().map(curve).collect(),
        dashed: lines.iter().map(|line| line.mean).collect(),
    }
}
