//! Curves and points over two axes, as a figure of the page.

use super::axes::{Axis, Place};
use crate::render::plot::axis;
use maud::{Markup, html};
use std::fmt::Write;
use std::ops::Range;

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    Line,
    Dashed,
    Dots,
    LineAndDots,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    pub name: String,
    pub mark: Mark,
    /// Which of the colours of the page.
    pub colour: usize,
    pub points: Vec<(f64, f64)>,
}

/// A diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    pub title: String,
    pub axes: [Axis; 2],
    pub series: Vec<Series>,
}

/// As many colours have the style sheet.
const COLOURS: usize = 6;
const CHART_SIZE: [f64; 2] = [560.0, 330.0];
const PLACE: Place = Place {
    left: 66.0,
    top: 10.0,
    width: 480.0,
    height: 272.0,
};

impl Chart {
    /// The figure: title, legend and drawing.
    pub fn draw(&self) -> Markup {
        let [width, height] = CHART_SIZE;
        let [x, y] = &self.axes;
        html! {
            figure class="chart" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.title) {
                    (PLACE.frame([x, y], true))
                    @for series in &self.series { (self.series(series)) }
                }
                ul class="legend" {
                    @for series in &self.series {
                        li { (swatch(series)) (series.name) }
                    }
                }
            }
        }
    }

    fn series(&self, series: &Series) -> Markup {
        let [x, y] = &self.axes;
        let drawn = series.points.iter().filter(|(u, v)| {
            let shown = |axis: &Axis, value: f64| !axis.logarithmic || value > 0.0;
            u.is_finite() && v.is_finite() && shown(x, *u) && shown(y, *v)
        });
        let places: Vec<[f64; 2]> = drawn.map(|p| PLACE.at([x, y], *p)).collect();
        let line = path(&places);
        html! {
            g class=(class(series)) {
                @if series.mark != Mark::Dots { path class="line" d=(line) {} }
                @if matches!(series.mark, Mark::Dots | Mark::LineAndDots) {
                    @for [u, v] in &places {
                        circle cx=(format!("{u:.1}")) cy=(format!("{v:.1}")) r="2.6" {}
                    }
                }
            }
        }
    }
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

fn class(series: &Series) -> String {
    let dashed = match series.mark {
        Mark::Dashed => " dashed",
        _ => "",
    };
    format!("c{}{dashed}", series.colour % COLOURS)
}

/// What the series looks like, for the legend.
fn swatch(series: &Series) -> Markup {
    html! {
        svg class="swatch" viewBox="0 0 30 10" aria-hidden="true" {
            g class=(class(series)) {
                @if series.mark != Mark::Dots { path class="line" d="M0 5H30" {} }
                @if matches!(series.mark, Mark::Dots | Mark::LineAndDots) { circle cx="15" cy="5" r="3" {} }
            }
        }
    }
}

/// The smallest range that holds all finite values; 0 to 1 where there are none.
pub fn extent(values: impl Iterator<Item = f64>) -> Range<f64> {
    axis::extent(values).map_or(0.0..1.0, |(low, high)| low..high)
}

/// From zero, or below where values are, to a little above the largest.
pub fn from_zero(values: impl Iterator<Item = f64>) -> Range<f64> {
    let all = extent(values.chain([0.0]));
    match all.end - all.start {
        height if height > 0.0 => all.start..all.end + 0.06 * height,
        _ => 0.0..1.0,
    }
}

/// The decades that hold all of the positive values.
pub fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let all = extent(values.filter(|v| *v > 0.0));
    let [low, high] = [
        all.start.max(1e-300).log10().floor(),
        all.end.log10().ceil(),
    ];
    10f64.powf(low)..10f64.powf(high.max(low + 1.0))
}
