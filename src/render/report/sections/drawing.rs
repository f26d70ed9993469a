//! Line drawings with dimensions, z upwards.

use crate::render::table::{Cell, Table};
use maud::{Markup, PreEscaped, html};
use std::fmt::Write;

/// A body of revolution or a plate, seen from one side.
pub(super) struct Drawing {
    text: String,
    /// Height of letters, and the unit that lines and gaps are multiples of.
    pub letter: f64,
}

/// A drawing that reaches over `[left, bottom, right, top]`, and a little more.
pub(super) fn frame(drawing: &Drawing, reach: [f64; 4], caption: &str) -> Markup {
    let margin = 2.0 * drawing.letter;
    let [x0, z0, x1, z1] = [
        reach[0] - margin,
        reach[1] - margin,
        reach[2] + 1.5 * margin,
        reach[3] + margin,
    ];
    let view = format!("{x0:.4} {:.4} {:.4} {:.4}", -z1, x1 - x0, z1 - z0);
    html! {
        figure class="sketch" {
            figcaption { (caption) }
            svg viewBox=(view) role="img" aria-label=(caption) {
                (PreEscaped(&drawing.text))
            }
        }
    }
}

/// A table of dimensions, in `unit`, that begins with those of the rollers.
pub(super) fn dimensions(unit: &str, diameter: f64, wall: Option<f64>, length: f64) -> Table {
    let mut table = Table::new("")
        .words("dimension")
        .words("")
        .figure("value", unit);
    dimension(&mut table, "D", "diameter of the rollers", diameter);
    if let Some(wall) = wall {
        dimension(&mut table, "w", "their wall", wall);
    }
    dimension(&mut table, "L", "their length", length);
    table
}

/// Adds a row to it.
pub(super) fn dimension(table: &mut Table, symbol: &str, what: &str, value: f64) {
    table.row([symbol.into(), what.into(), Cell::figure(value)]);
}

impl Drawing {
    /// With letters of this height.
    pub fn new(letter: f64) -> Self {
        Self {
            text: String::new(),
            letter,
        }
    }

    fn add(&mut self, element: std::fmt::Arguments) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(element);
    }

    pub fn rectangle(&mut self, [x0, z0, x1, z1]: [f64; 4]) {
        self.polygon(&[(x0, z0), (x1, z0), (x1, z1), (x0, z1)]);
    }

    pub fn polygon(&mut self, points: &[(f64, f64)]) {
        let points: Vec<String> = points
            .iter()
            .map(|(x, z)| format!("{x:.4},{:.4}", -z))
            .collect();
        let points = points.join(" ");
        let line = 0.06 * self.letter;
        self.add(format_args!(
            "<polygon points=\"{points}\" fill=\"#eef1f4\" stroke=\"#1c2126\" stroke-width=\"{line:.4}\"/>"
        ));
    }

    pub fn circle(&mut self, (x, z): (f64, f64), radius: f64) {
        let line = 0.06 * self.letter;
        self.add(format_args!(
            "<circle cx=\"{x:.4}\" cy=\"{:.4}\" r=\"{radius:.4}\" fill=\"#fff\" stroke=\"#1c2126\" stroke-width=\"{line:.4}\"/>",
            -z
        ));
    }

    fn stroke(&mut self, from: (f64, f64), to: (f64, f64), more: &str) {
        let line = 0.04 * self.letter;
        self.add(format_args!(
            "<line x1=\"{:.4}\" y1=\"{:.4}\" x2=\"{:.4}\" y2=\"{:.4}\" stroke=\"#0b5cad\" stroke-width=\"{line:.4}\"{more}/>",
            from.0, -from.1, to.0, -to.1
        ));
    }

    pub fn dashed(&mut self, from: (f64, f64), to: (f64, f64)) {
        let (on, off) = (0.5 * self.letter, 0.3 * self.letter);
        self.stroke(from, to, &format!(" stroke-dasharray=\"{on:.4} {off:.4}\""));
    }

    /// A line with short strokes at both ends, and its name beside it.
    pub fn dimension(&mut self, from: (f64, f64), to: (f64, f64), name: &str) {
        self.stroke(from, to, "");
        let tick = 0.35 * self.letter;
        let upright = from.0 == to.0;
        for (x, z) in [from, to] {
            match upright {
                true => self.stroke((x - tick, z), (x + tick, z), ""),
                false => self.stroke((x, z - tick), (x, z + tick), ""),
            }
        }
        let middle = (0.5 * (from.0 + to.0), 0.5 * (from.1 + to.1));
        let beside = match upright {
            true => (middle.0 + 0.9 * self.letter, middle.1 - 0.35 * self.letter),
            false => (middle.0, middle.1 + 0.45 * self.letter),
        };
        self.label(beside, name);
    }

    pub fn label(&mut self, (x, z): (f64, f64), name: &str) {
        let size = self.letter;
        self.add(format_args!(
            "<text x=\"{x:.4}\" y=\"{:.4}\" font-size=\"{size:.4}\" text-anchor=\"middle\" fill=\"#1c2126\">{name}</text>",
            -z
        ));
    }
}
