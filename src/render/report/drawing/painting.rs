//! A field painted over two axes, with outlines and the scale of its colours.

use super::colours;
use super::raster::Raster;
use crate::answer::pictures::Patch;
use crate::render::OutputError;
use crate::render::plot::frame::{Axis, Viewport};
use maud::{Markup, html};
use std::fmt::Write;

/// A word at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    pub at: [f64; 2],
    pub text: String,
}

/// A painted field.
#[derive(Debug, Clone, PartialEq)]
pub struct Painting {
    pub title: String,
    pub axes: [Axis; 2],
    /// What the colours are, with the unit, and the value of the last one; the first is zero.
    pub quantity: String,
    pub largest: f64,
    pub patches: Vec<Patch>,
    /// Edges of the parts.
    pub outlines: Vec<[[f64; 2]; 2]>,
    pub labels: Vec<Label>,
    /// Height over width of the field.
    pub shape: f64,
    /// Width of the field in the units of the picture.
    pub width: f64,
}

const LEFT_MARGIN: f64 = 66.0;
const TOP_MARGIN: f64 = 12.0;
const BOTTOM_MARGIN: f64 = 44.0;
const SCALE_GAP: f64 = 22.0;
const SCALE_WIDTH: f64 = 14.0;
const SCALE_WORDS: f64 = 66.0;
/// Pixels a unit of the picture.
const PIXELS_PER_UNIT: f64 = 1.5;

impl Painting {
    /// The figure.
    ///
    /// # Errors
    /// Where the picture cannot be encoded.
    pub fn draw(&self, name: &str) -> Result<Markup, OutputError> {
        let place = Viewport {
            left: LEFT_MARGIN,
            top: TOP_MARGIN,
            width: self.width,
            height: (self.width * self.shape).round(),
        };
        let axes = [&self.axes[0], &self.axes[1]];
        let image = self.image(&place).address()?;
        let (width, height) = (
            LEFT_MARGIN + self.width + SCALE_GAP + SCALE_WIDTH + SCALE_WORDS,
            TOP_MARGIN + place.height + BOTTOM_MARGIN,
        );
        let clip = format!("clip-{name}");
        Ok(html! {
            figure class="painting" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.title)
                    style=(format!("max-width:{:.0}px", 1.15 * width)) {
                    clipPath id=(clip) {
                        rect x=(place.left) y=(place.top) width=(place.width) height=(place.height) {}
                    }
                    image x=(place.left) y=(place.top) width=(place.width) height=(place.height)
                        preserveAspectRatio="none" href=(image) {}
                    g clip-path=(format!("url(#{clip})")) {
                        path class="outline" d=(self.outline(&place)) {}
                        @for label in &self.labels {
                            @let [u, v] = place.at(axes, (label.at[0], label.at[1]));
                            text class="part" x=(format!("{u:.1}")) y=(format!("{v:.1}")) text-anchor="middle" { (label.text) }
                        }
                    }
                    (place.frame(axes, false))
                    (self.scale(&place, name))
                }
            }
        })
    }

    fn image(&self, place: &Viewport) -> Raster {
        let pixels = |units: f64| (PIXELS_PER_UNIT * units).round().max(1.0);
        let (width, height) = (pixels(place.width), pixels(place.height));
        let mut raster = Raster::new(width as usize, height as usize);
        let [x, y] = &self.axes;
        for patch in &self.patches {
            let corners = patch.corners.iter().zip(&patch.values).map(|(at, value)| {
                let pixel = [x.share(at[0]) * width, (1.0 - y.share(at[1])) * height];
                (pixel, value / self.largest)
            });
            raster.paint(&corners.collect::<Vec<_>>());
        }
        raster
    }

    fn outline(&self, place: &Viewport) -> String {
        let mut path = String::new();
        for [a, b] in &self.outlines {
            let [a, b] = [a, b].map(|p| place.at([&self.axes[0], &self.axes[1]], (p[0], p[1])));
            // Writing to a string cannot fail.
            let _ = write!(path, "M{:.1} {:.1}L{:.1} {:.1}", a[0], a[1], b[0], b[1]);
        }
        path
    }

    /// The colours beside the field, and what they stand for.
    fn scale(&self, place: &Viewport, name: &str) -> Markup {
        let left = place.left + place.width + SCALE_GAP;
        let axis = Axis::linear("", 0.0..self.largest);
        let ticks = axis.ticks((place.height / 40.0).clamp(2.0, 8.0) as usize);
        let middle = place.top + 0.5 * place.height;
        html! {
            linearGradient id=(format!("scale-{name}")) x1="0" y1="1" x2="0" y2="0" {
                @for k in 0..=16 {
                    stop offset=(format!("{:.4}", f64::from(k) / 16.0)) stop-color=(colours::css(f64::from(k) / 16.0)) {}
                }
            }
            g class="axes" {
                rect class="scale" x=(left) y=(place.top) width=(SCALE_WIDTH) height=(place.height)
                    style=(format!("fill:url(#scale-{name})")) {}
                @for (value, name) in ticks {
                    text x=(left + SCALE_WIDTH + 6.0)
                        y=(format!("{:.1}", place.top + (1.0 - axis.share(value)) * place.height + 4.0)) { (name) }
                }
                text transform=(format!("translate({} {middle}) rotate(-90)", left + SCALE_WIDTH + 56.0))
                    text-anchor="middle" { (self.quantity) }
            }
        }
    }
}
