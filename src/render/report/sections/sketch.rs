//! A sketch of the bearing with its dimensions: a view along the upper roller, and one along the lower roller.

use super::drawing::{Drawing, dimension, dimensions, frame};
use super::line_sketch::line_sketch;
use crate::render::report::Inputs;
use crate::render::report::calculation::{CrossedSketch, Sketch};
use crate::render::table::Table;
use crate::render::table::html::table;
use crate::render::text::significant;
use maud::{Markup, html};

/// Nothing where the case is no bearing.
pub fn sketch(inputs: &Inputs) -> Markup {
    let unit = &inputs.summary.units.length;
    let sketch = match &inputs.calculation.sketch {
        Some(Sketch::Crossed(sketch)) => sketch,
        Some(Sketch::Line(sketch)) => return line_sketch(sketch, unit),
        None => return html! {},
    };
    html! {
        div class="pair" {
            (view(sketch, true))
            (view(sketch, false))
        }
        (table(&crossed_dimensions(sketch, unit)))
    }
}

fn crossed_dimensions(sketch: &CrossedSketch, unit: &str) -> Table {
    let mut table = dimensions(unit, sketch.diameter, sketch.wall, sketch.length);
    let mut row = |symbol: &str, what: &str, value| dimension(&mut table, symbol, what, value);
    row(
        "s",
        "axes of the rollers from the middle of the intermediate plate",
        sketch.offset,
    );
    for (symbol, what, value) in [
        ("t1", "upper plate", sketch.thickness[0]),
        (
            "t2",
            "intermediate plate, where its valleys cross",
            sketch.thickness[1],
        ),
        ("t3", "lower plate", sketch.thickness[2]),
    ] {
        row(symbol, &format!("thickness of the {what}"), value);
    }
    row("Bx", "plates along x", sketch.plan[0]);
    row("By", "plates along y", sketch.plan[1]);
    let slope = significant(sketch.slope.to_degrees(), 5);
    table.note(format!(
        "θ: slope of each side of a valley, {slope} degrees. Ends of the rollers: {}.",
        sketch.ends
    ));
    table
}

/// Along the upper roller, whose circle is then seen, or along the lower one.
fn view(sketch: &CrossedSketch, along_upper: bool) -> Markup {
    let across = if along_upper { 0 } else { 1 };
    let width = sketch.plan[across];
    let (radius, rise) = (0.5 * sketch.diameter, sketch.slope.tan());
    let [t1, t2, t3] = sketch.thickness;
    // The middle of the stack is that of the intermediate plate; on its slope a roller's axis is R / cos θ above it.
    let axis = 0.5 * t2 + radius / sketch.slope.cos() + sketch.offset.abs() * rise;
    let bottom_of_upper = axis + radius;
    let half = 0.5 * width;
    let mut d = Drawing::new(0.045 * (2.0 * bottom_of_upper + t1 + t3).max(width));
    let (own, other) = if along_upper {
        (1.0, -1.0)
    } else {
        (-1.0, 1.0)
    };
    // The plate of the roller that is seen as a circle is displaced by 2 s, the other one is not, in this view.
    let (shift, s) = (2.0 * sketch.offset, sketch.offset);
    let plate = |up: bool| {
        let (near, thick) = if up {
            (bottom_of_upper, t1)
        } else {
            (bottom_of_upper, t3)
        };
        let sign = if up { 1.0 } else { -1.0 };
        let moved = if (own > 0.0) == up { shift } else { 0.0 };
        [
            moved - half,
            sign * near,
            moved + half,
            sign * (near + thick),
        ]
    };
    let (upper, lower) = (plate(true), plate(false));
    d.rectangle(upper);
    d.rectangle(lower);
    // The intermediate plate: its valley on the side of the circle, its straight side on the other.
    let far = 0.5 * t2 + half * rise;
    let valley = [(-half, own * far), (0.0, own * 0.5 * t2), (half, own * far)];
    let level = 0.5 * t2 + 0.5 * sketch.plan[1 - across] * rise;
    let mut outline: Vec<(f64, f64)> = valley.to_vec();
    outline.extend([(half, other * level), (-half, other * level)]);
    d.polygon(&outline);
    d.dashed((-half, other * 0.5 * t2), (half, other * 0.5 * t2));
    // The roller on end, and the other one from its side.
    d.circle((s, own * axis), radius);
    if let Some(wall) = sketch.wall {
        d.circle((s, own * axis), radius - wall);
    }
    let long = 0.5 * sketch.length;
    d.rectangle([
        -long,
        other * (axis - radius),
        long,
        other * (axis + radius),
    ]);
    // Dimensions.
    let gap = 2.2 * d.letter;
    let left = upper[0].min(lower[0]).min(-half) - gap;
    let right = upper[2].max(lower[2]).max(half) + gap;
    let name = if along_upper { "Bx" } else { "By" };
    let top = upper[3] + gap;
    d.dimension((upper[0], top), (upper[2], top), name);
    d.dimension(
        (left, own * (axis - radius)),
        (left, own * (axis + radius)),
        "D",
    );
    d.dimension((right, upper[1]), (right, upper[3]), "t1");
    d.dimension((right, -0.5 * t2), (right, 0.5 * t2), "t2");
    d.dimension((right, lower[1]), (right, lower[3]), "t3");
    let foot = lower[3] - gap;
    d.dimension((-long, foot), (long, foot), "L");
    if let Some(wall) = sketch.wall {
        let at = own * axis;
        d.dimension((s + radius - wall, at), (s + radius, at), "w");
    }
    if s != 0.0 {
        let at = own * (axis + 0.35 * radius);
        d.dashed((0.0, own * 0.5 * t2), (0.0, at));
        d.dimension((0.0, at), (s, at), "s");
    }
    d.label((0.62 * half, own * (0.5 * t2 + 0.2 * half * rise)), "θ");
    let caption = match along_upper {
        true => "Along the upper roller (y): x to the right, z up",
        false => "Along the lower roller (x): y to the right, z up",
    };
    frame(&d, [left, foot, right, top], caption)
}
