//! Figures as parts of the page: a drawing for each panel, its legend below.

use super::axis::ranges;
use super::data::{Line, Panel, PlotFigure, Scale};
use super::frame::{Axis, Viewport};
use maud::{Markup, html};
use std::fmt::Write;

/// As many colours have the style sheet.
const COLOURS: usize = 6;
const CHART_SIZE: [f64; 2] = [560.0, 330.0];
const PLACE: Viewport = Viewport {
    left: 66.0,
    top: 10.0,
    width: 480.0,
    height: 272.0,
};

/// The panels of the figures, two beside each other.
pub fn charts<'f>(figures: impl IntoIterator<Item = &'f PlotFigure>) -> Markup {
    let figures = figures.into_iter();
    let panels = figures.flat_map(|figure| figure.panels.iter().map(move |panel| (figure, panel)));
    html! {
        div class="pair" { @for (figure, panel) in panels { (chart(figure, panel)) } }
    }
}

fn chart(figure: &PlotFigure, panel: &Panel) -> Markup {
    let [width, height] = CHART_SIZE;
    let [x, y] = axes(panel);
    let mut styles: Vec<&Line> = panel.lines.iter().collect();
    styles.sort_by_key(|line| line.style);
    styles.dedup_by_key(|line| line.style);
    html! {
        figure class="chart" {
            figcaption { (panel.title) }
            svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(panel.title) {
                (PLACE.frame([&x, &y], true))
                @for line in &panel.lines { (curve(line, [&x, &y])) }
                @for level in &panel.dashed { (dashed(*level, [&x, &y])) }
            }
            ul class="legend" {
                @for line in styles {
                    @if let Some(name) = figure.legend.get(line.style) { li { (swatch(line)) (name) } }
                }
                @if !panel.dashed.is_empty() { li { (dashed_swatch()) (figure.dashed) } }
            }
        }
    }
}

fn axes(panel: &Panel) -> [Axis; 2] {
    let [x, y] = ranges(panel);
    let [along, up] = panel.axes.clone();
    match panel.scale {
        Scale::Decades => [Axis::decades(along, x), Axis::decades(up, y)],
        Scale::DecadesUp => [Axis::linear(along, x), Axis::decades(up, y)],
        Scale::Linear => [Axis::linear(along, x), Axis::linear(up, y)],
    }
}

fn curve(line: &Line, [x, y]: [&Axis; 2]) -> Markup {
    let drawn = line.points.iter().filter(|(u, v)| {
        let shown = |axis: &Axis, value: f64| !axis.logarithmic || value > 0.0;
        u.is_finite() && v.is_finite() && shown(x, *u) && shown(y, *v)
    });
    let places: Vec<[f64; 2]> = drawn.map(|p| PLACE.at([x, y], *p)).collect();
    html! {
        g class=(class(line)) {
            path class="line" d=(path(&places)) {}
            @if line.dots {
                @for [u, v] in &places {
                    circle cx=(format!("{u:.1}")) cy=(format!("{v:.1}")) r="2.6" {}
                }
            }
        }
    }
}

fn dashed(level: f64, [x, y]: [&Axis; 2]) -> Markup {
    let ends = [x.range.start, x.range.end].map(|u| PLACE.at([x, y], (u, level)));
    html! { g class="level" { path class="line" d=(path(&ends)) {} } }
}

/// Straight pieces through the places.
fn path(places: &[[f64; 2]]) -> String {
    let mut path = String::new();
    for (k, [u, v]) in places.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(path, "{}{u:.1} {v:.1}", if k == 0 { 'M' } else { 'L' });
    }
    path
}

fn class(line: &Line) -> String {
    format!("c{}", line.style % COLOURS)
}

/// What the line looks like, for the legend.
fn swatch(line: &Line) -> Markup {
    html! {
        svg class="swatch" viewBox="0 0 30 10" aria-hidden="true" {
            g class=(class(line)) {
                path class="line" d="M0 5H30" {}
                @if line.dots { circle cx="15" cy="5" r="3" {} }
            }
        }
    }
}

fn dashed_swatch() -> Markup {
    html! {
        svg class="swatch" viewBox="0 0 30 10" aria-hidden="true" {
            g class="level" { path class="line" d="M0 5H30" {} }
        }
    }
}
