//! Errors on logarithmic axes, as SVG.

use super::ConvergeError;
use super::peers::Peers;
use super::study::{Curve, Level, Reference, Study};
use crate::output::file::write_atomically;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::path::Path;

/// A line in a panel: its place in the legend, and points (x, error in percent).
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub style: usize,
    pub points: Vec<(f64, f64)>,
}

/// One diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub title: String,
    pub x: &'static str,
    pub lines: Vec<Line>,
    /// Errors below this, in percent, cannot be told from the uncertainty of the reference.
    pub floor: Option<f64>,
}

/// Diagrams in two columns, with one legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub panels: Vec<Panel>,
    pub legend: Vec<String>,
}

/// Colours that colour-blind readers can tell apart (Okabe and Ito).
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];
const GREY: RGBColor = RGBColor(120, 120, 120);
const WIDTH: u32 = 960;
const PANEL: u32 = 330;
const LEGEND_LINE: u32 = 20;
/// What a level is drawn against.
type Abscissa = fn(&Level) -> f64;

/// More quantities than this are drawn against one axis only.
const MANY: usize = 12;
/// Smaller errors are drawn as this, in percent.
const LEAST: f64 = 1e-3;

/// Every quantity with errors, against unknowns on the left and CPU seconds on the right; where
/// they are many, against CPU seconds only.
pub fn figure(study: &Study) -> Figure {
    let curves = study.curves();
    let elements = study.elements();
    let mut panels = Vec::new();
    let many = study.quantities.len() > MANY;
    for quantity in &study.quantities {
        let of: Vec<&Curve> = curves
            .iter()
            .filter(|c| c.quantity == quantity.name)
            .collect();
        let axes: [(&'static str, Abscissa); 2] = [
            ("unknowns", |l| l.dofs as f64),
            ("CPU seconds", |l| l.cost.cpu_s),
        ];
        for (x, at) in axes.into_iter().skip(usize::from(many)) {
            let lines = of.iter().filter_map(|c| own_line(study, &elements, c, at));
            panels.push(Panel {
                title: format!("{}, error in %", quantity.name),
                x,
                lines: lines.collect(),
                floor: of.first().and_then(|c| floor(c)),
            });
        }
    }
    panels.retain(|p| p.lines.iter().any(|l| !l.points.is_empty()));
    Figure {
        panels,
        legend: own_names(&elements),
    }
}

/// Problem H against CPU seconds, with the stored results of other programs.
pub fn figure_with_peers(study: &Study, peers: &Peers) -> Figure {
    const SHOWN: [&str; 6] = [
        "p0",
        "half-width",
        "Mises block, integration point",
        "Mises cylinder, integration point",
        "Mises block, nodal",
        "Mises cylinder, nodal",
    ];
    let curves = study.curves();
    let elements = study.elements();
    let mut panels = Vec::new();
    for name in SHOWN {
        let of = || curves.iter().filter(|c| c.quantity == name);
        let mut lines: Vec<Line> = of()
            .filter_map(|c| own_line(study, &elements, c, |l| l.cost.cpu_s))
            .collect();
        for (k, peer) in peers.curves.iter().enumerate() {
            let point = |row: &super::peers::PeerRow| {
                Some((row.cpu_s, percent(row.error_percent.of(name)?)))
            };
            lines.push(Line {
                style: elements.len() + k,
                points: peer.rows.iter().filter_map(point).collect(),
            });
        }
        panels.push(Panel {
            title: format!("{name}, error in %"),
            x: "CPU seconds",
            lines,
            floor: of().next().and_then(floor),
        });
    }
    let mut legend = own_names(&elements);
    legend.extend(peers.curves.iter().map(|p| p.name()));
    Figure { panels, legend }
}

fn own_names(elements: &[&str]) -> Vec<String> {
    let name = |e: &&str| format!("Brinell, {e}");
    elements.iter().map(name).collect()
}

fn percent(error: f64) -> f64 {
    (100.0 * error.abs()).max(LEAST)
}

fn floor(curve: &Curve) -> Option<f64> {
    match curve.reference {
        Some(Reference::Known { within, .. }) if within > 0.0 => Some(100.0 * within),
        _ => None,
    }
}

fn own_line(
    study: &Study,
    elements: &[&str],
    curve: &Curve,
    at: impl Fn(&Level) -> f64,
) -> Option<Line> {
    let levels = study.levels_of(curve.element);
    let points = levels.iter().zip(&curve.errors);
    Some(Line {
        style: elements.iter().position(|e| *e == curve.element)?,
        points: points
            .filter_map(|(level, error)| Some((at(level), percent((*error)?))))
            .filter(|(x, _)| *x > 0.0)
            .collect(),
    })
}

/// Draws the figure and writes it, whole or not at all.
///
/// # Errors
/// Where it cannot be drawn or the file cannot be written.
pub fn write(figure: &Figure, path: &Path) -> Result<(), ConvergeError> {
    let text = svg(figure)?;
    Ok(write_atomically(path, |out| {
        out.write_all(text.as_bytes())
    })?)
}

/// The figure as the text of an SVG file.
///
/// # Errors
/// [`ConvergeError::Plot`], where the drawing library refuses.
pub fn svg(figure: &Figure) -> Result<String, ConvergeError> {
    let mut text = String::new();
    draw(figure, &mut text).map_err(|error| ConvergeError::Plot(error.to_string()))?;
    Ok(text)
}

type Outcome = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn draw(figure: &Figure, text: &mut String) -> Outcome {
    let rows = figure.panels.len().div_ceil(2).max(1) as u32;
    let below = LEGEND_LINE * (figure.legend.len() as u32 + 2);
    let root = SVGBackend::with_string(text, (WIDTH, rows * PANEL + below)).into_drawing_area();
    root.fill(&WHITE)?;
    let (upper, lower) = root.split_vertically(rows * PANEL);
    let places = upper.split_evenly((rows as usize, 2));
    for (panel, place) in figure.panels.iter().zip(&places) {
        diagram(panel, place)?;
    }
    legend(figure, &lower)?;
    root.present()?;
    Ok(())
}

fn colour(style: usize) -> RGBColor {
    COLOURS[style % COLOURS.len()]
}

/// The decades that hold all of the values.
fn decades(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values
        .filter(|v| v.is_finite() && *v > 0.0)
        .fold((f64::INFINITY, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return 0.1..10.0;
    }
    let [low, mut high] = [
        low.log10().floor() as i32,
        (high * 1.001).log10().ceil() as i32,
    ];
    if low == high {
        high += 1;
    }
    10f64.powi(low)..10f64.powi(high)
}

fn tick(value: &f64) -> String {
    match value.log10().round() as i32 {
        power @ -4..=4 => format!("{:.*}", (-power).max(0) as usize, value),
        power => format!("1e{power}"),
    }
}

fn diagram(panel: &Panel, place: &Area) -> Outcome {
    let points = || panel.lines.iter().flat_map(|l| l.points.iter());
    let (x, y) = (
        decades(points().map(|p| p.0)),
        decades(points().map(|p| p.1)),
    );
    let mut chart = ChartBuilder::on(place)
        .caption(&panel.title, ("sans-serif", 16))
        .margin(12)
        .x_label_area_size(38)
        .y_label_area_size(52)
        .build_cartesian_2d(x.clone().log_scale(), y.clone().log_scale())?;
    chart
        .configure_mesh()
        .x_desc(panel.x)
        .x_label_formatter(&tick)
        .y_label_formatter(&tick)
        .label_style(("sans-serif", 13))
        .light_line_style(GREY.mix(0.1))
        .bold_line_style(GREY.mix(0.35))
        .draw()?;
    if let Some(floor) = panel.floor.filter(|f| y.contains(f)) {
        let ends = [(x.start, floor), (x.end, floor)];
        chart.draw_series(DashedLineSeries::new(ends, 4, 4, GREY.stroke_width(1)))?;
    }
    for line in &panel.lines {
        let colour = colour(line.style);
        chart.draw_series(LineSeries::new(line.points.clone(), colour.stroke_width(2)))?;
        let dots = line
            .points
            .iter()
            .map(|p| Circle::new(*p, 4, colour.filled()));
        chart.draw_series(dots)?;
    }
    Ok(())
}

fn legend(figure: &Figure, place: &Area) -> Outcome {
    let font = || ("sans-serif", 14).into_font();
    let row = |k: usize| LEGEND_LINE as i32 * k as i32 + 10;
    for (k, name) in figure.legend.iter().enumerate() {
        let (y, colour) = (row(k), colour(k));
        let ends = vec![(64, y), (94, y)];
        place.draw(&PathElement::new(ends, colour.stroke_width(2)))?;
        place.draw(&Circle::new((79, y), 4, colour.filled()))?;
        place.draw(&Text::new(name.clone(), (104, y - 7), font()))?;
    }
    if figure.panels.iter().any(|p| p.floor.is_some()) {
        let y = row(figure.legend.len());
        for start in [64, 74, 84] {
            let dash = vec![(start, y), (start + 5, y)];
            place.draw(&PathElement::new(dash, GREY.stroke_width(1)))?;
        }
        let words = "uncertainty of the reference: errors below it mean nothing";
        place.draw(&Text::new(words, (104, y - 7), font()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::peers::peers;
    use super::super::study::tests::study;
    use super::*;

    #[test]
    fn a_figure_has_its_lines_and_its_legend() {
        let figure = figure(&study());
        assert_eq!(figure.panels.len(), 6);
        assert_eq!(figure.panels[0].lines[0].points.len(), 3);
        let text = svg(&figure).unwrap();
        assert!(text.starts_with("<svg") && text.contains("Brinell, bbar"));
    }

    #[test]
    fn other_programs_stand_beside() {
        let figure = figure_with_peers(&study(), &peers().unwrap());
        assert_eq!(figure.legend.len(), 5);
        assert!(svg(&figure).unwrap().contains("CalculiX"));
    }

    #[test]
    fn nothing_to_draw_is_an_empty_figure() {
        let empty = figure(&Study::new("none", "none".into()));
        assert!(empty.panels.is_empty() && svg(&empty).is_ok());
    }

    #[test]
    fn ranges_are_whole_decades() {
        assert_eq!(decades([0.03, 5.0].into_iter()), 0.01..10.0);
        assert_eq!(decades([1.0].into_iter()), 1.0..10.0);
        assert_eq!(decades(std::iter::empty()), 0.1..10.0);
        assert_eq!(
            [tick(&0.01), tick(&100.0), tick(&1e6)],
            ["0.01", "100", "1e6"]
        );
    }
}
