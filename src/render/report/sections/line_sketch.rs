//! A sketch of parallel rollers between two plates with their dimensions: a view along the rollers, and one across.

use super::drawing::{Drawing, dimension, dimensions, frame};
use crate::render::report::calculation::LineSketch;
use crate::render::table::Table;
use crate::render::table::html::table;
use maud::{Markup, html};

/// Two views and the table of dimensions, in `unit`.
pub fn line_sketch(sketch: &LineSketch, unit: &str) -> Markup {
    html! {
        div class="pair" {
            (view(sketch, true))
            (view(sketch, false))
        }
        (table(&line_dimensions(sketch, unit)))
    }
}

/// Along the rollers, which are then circles, or across them.
fn view(sketch: &LineSketch, along: bool) -> Markup {
    let side = if along { 0 } else { 1 };
    let radius = 0.5 * sketch.diameter;
    let [t1, t2] = sketch.thickness;
    let [upper, lower] = sketch.plan.map(|plan| 0.5 * plan[side]);
    let wide = upper.max(lower);
    let mut d = Drawing::new(0.045 * (sketch.diameter + t1 + t2).max(2.0 * wide));
    d.rectangle([-upper, radius, upper, radius + t1]);
    d.rectangle([-lower, -radius - t2, lower, -radius]);
    if along {
        for place in &sketch.places {
            d.circle((*place, 0.0), radius);
            if let Some(wall) = sketch.wall {
                d.circle((*place, 0.0), radius - wall);
            }
        }
    } else {
        let half = 0.5 * sketch.length;
        d.rectangle([-half, -radius, half, radius]);
    }
    let gap = 2.2 * d.letter;
    let (left, right) = (-wide - gap, wide + gap);
    let (top, foot) = (radius + t1 + gap, -radius - t2 - gap);
    let [above, below] = match along {
        true => ["B1x", "B2x"],
        false => ["B1y", "B2y"],
    };
    d.dimension((-upper, top), (upper, top), above);
    d.dimension((-lower, foot), (lower, foot), below);
    d.dimension((left, -radius), (left, radius), "D");
    d.dimension((right, radius), (right, radius + t1), "t1");
    d.dimension((right, -radius - t2), (right, -radius), "t2");
    match (along, sketch.places.as_slice()) {
        (true, [first, second, ..]) => d.dimension((*first, 0.0), (*second, 0.0), "a"),
        (false, _) => d.dimension((-0.5 * sketch.length, 0.0), (0.5 * sketch.length, 0.0), "L"),
        _ => {}
    }
    if let (true, Some(wall), Some(last)) = (along, sketch.wall, sketch.places.last()) {
        d.dimension((last + radius - wall, 0.0), (last + radius, 0.0), "w");
    }
    let caption = match along {
        true => "Along the rollers (y): x to the right, z up",
        false => "Across the rollers (x): y to the right, z up",
    };
    frame(&d, [left, foot, right, top], caption)
}

fn line_dimensions(sketch: &LineSketch, unit: &str) -> Table {
    let mut table = dimensions(unit, sketch.diameter, sketch.wall, sketch.length);
    let mut row = |symbol: &str, what: &str, value| dimension(&mut table, symbol, what, value);
    if let [first, second, ..] = sketch.places.as_slice() {
        row(
            "a",
            "distance between the axes of neighbours",
            second - first,
        );
    }
    for (number, name) in ["upper", "lower"].into_iter().enumerate() {
        let n = number + 1;
        let plan = sketch.plan[number];
        row(
            &format!("t{n}"),
            &format!("thickness of the {name} plate"),
            sketch.thickness[number],
        );
        row(&format!("B{n}x"), &format!("{name} plate along x"), plan[0]);
        row(&format!("B{n}y"), &format!("{name} plate along y"), plan[1]);
    }
    let curved = sketch.curved.as_ref().map(|curved| format!(" {curved}"));
    table.note(format!(
        "Ends of the rollers: {}.{}",
        sketch.ends,
        curved.unwrap_or_default()
    ));
    table
}
