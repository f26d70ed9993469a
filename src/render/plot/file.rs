//! Figures as files of their own: panels in two columns, one legend below.

use super::axis::{plain, power, ranges};
use super::data::{Panel, PlotFigure, Scale};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;
use std::ops::Range;

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
const FIGURE_WIDTH: u32 = 960;
const PANEL_HEIGHT: u32 = 330;
const LEGEND_LINE_HEIGHT: u32 = 20;
/// Widths of a line, and of one that another may hide.
const STROKES: [u32; 2] = [2, 5];

type Outcome = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b, X, Y> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>;
type Tick<'t> = &'t dyn Fn(&f64) -> String;

pub fn draw(figure: &PlotFigure, text: &mut String) -> Outcome {
    let rows = figure.panels.len().div_ceil(2).max(1) as u32;
    let below = LEGEND_LINE_HEIGHT * (figure.legend.len() as u32 + 2);
    let root = SVGBackend::with_string(text, (FIGURE_WIDTH, rows * PANEL_HEIGHT + below))
        .into_drawing_area();
    root.fill(&WHITE)?;
    let (upper, lower) = root.split_vertically(rows * PANEL_HEIGHT);
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

fn diagram(panel: &Panel, place: &Area) -> Outcome {
    let mut builder = ChartBuilder::on(place);
    builder
        .caption(&panel.title, ("sans-serif", 16))
        .margin(12)
        .x_label_area_size(38)
        .y_label_area_size(if panel.axes[1].is_empty() { 52 } else { 66 });
    let [x, y] = ranges(panel);
    let (at_x, at_y) = (|v: &f64| plain(*v, &x), |v: &f64| plain(*v, &y));
    match panel.scale {
        Scale::Decades => {
            let (x_log, y_log) = (x.clone().log_scale(), y.clone().log_scale());
            let mut chart = builder.build_cartesian_2d(x_log, y_log)?;
            mesh(&mut chart, panel, [&power, &power])?;
            lines(&mut chart, panel, [&x, &y])
        }
        Scale::DecadesUp => {
            let y_log = y.clone().log_scale();
            let mut chart = builder.build_cartesian_2d(x.clone(), y_log)?;
            mesh(&mut chart, panel, [&at_x, &power])?;
            lines(&mut chart, panel, [&x, &y])
        }
        Scale::Linear => {
            let mut chart = builder.build_cartesian_2d(x.clone(), y.clone())?;
            mesh(&mut chart, panel, [&at_x, &at_y])?;
            lines(&mut chart, panel, [&x, &y])
        }
    }
}

fn mesh<X, Y>(chart: &mut Chart<X, Y>, panel: &Panel, ticks: [Tick; 2]) -> Outcome
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let [x, y] = &panel.axes;
    let mut mesh = chart.configure_mesh();
    if !y.is_empty() {
        mesh.y_desc(y);
    }
    mesh.x_desc(x)
        .x_label_formatter(ticks[0])
        .y_label_formatter(ticks[1])
        .label_style(("sans-serif", 13))
        .light_line_style(GREY.mix(0.1))
        .bold_line_style(GREY.mix(0.35))
        .draw()?;
    Ok(())
}

fn lines<X, Y>(chart: &mut Chart<X, Y>, panel: &Panel, range: [&Range<f64>; 2]) -> Outcome
where
    X: Ranged<ValueType = f64>,
    Y: Ranged<ValueType = f64>,
{
    let [x, y] = range;
    let linear = panel.scale == Scale::Linear;
    for level in panel.dashed.iter().filter(|level| y.contains(level)) {
        let ends = [(x.start, *level), (x.end, *level)];
        chart.draw_series(DashedLineSeries::new(ends, 4, 4, GREY.stroke_width(1)))?;
    }
    for (k, line) in panel.lines.iter().enumerate() {
        let colour = colour(line.style);
        let hidden = linear && k + 1 < panel.lines.len();
        let style = colour.stroke_width(STROKES[usize::from(hidden)]);
        chart.draw_series(LineSeries::new(line.points.clone(), style))?;
        let size = if linear { 3 } else { 4 };
        let shown = line.points.iter().filter(|_| line.dots);
        let dots = shown.map(|p| Circle::new(*p, size, colour.filled()));
        chart.draw_series(dots)?;
    }
    Ok(())
}

fn legend(figure: &PlotFigure, place: &Area) -> Outcome {
    let font = || ("sans-serif", 14).into_font();
    let row = |k: usize| LEGEND_LINE_HEIGHT as i32 * k as i32 + 10;
    for (k, name) in figure.legend.iter().enumerate() {
        let (y, colour) = (row(k), colour(k));
        let ends = vec![(64, y), (94, y)];
        place.draw(&PathElement::new(ends, colour.stroke_width(2)))?;
        place.draw(&Circle::new((79, y), 4, colour.filled()))?;
        place.draw(&Text::new(name.clone(), (104, y - 7), font()))?;
    }
    if figure.panels.iter().any(|p| !p.dashed.is_empty()) {
        let y = row(figure.legend.len());
        for start in [64, 74, 84] {
            let dash = vec![(start, y), (start + 5, y)];
            place.draw(&PathElement::new(dash, GREY.stroke_width(1)))?;
        }
        place.draw(&Text::new(figure.dashed.clone(), (104, y - 7), font()))?;
    }
    Ok(())
}
