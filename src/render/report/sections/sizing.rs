//! The sizing rules (2-49) to (2-51).

use crate::render::report::figures::{number, share};
use crate::render::report::html::{met, row, table};
use crate::render::summary::{Sizing, SizingRule, Summary};
use crate::render::text::significant;
use maud::{Markup, html};

pub fn sizing(summary: &Summary) -> Markup {
    let Some(sizing) = &summary.sizing else {
        return Markup::default();
    };
    html! {
        @if let Some(rule) = &sizing.rule { (demands(rule, summary)) }
        (lines(sizing, summary))
    }
}

fn demands(rule: &SizingRule, summary: &Summary) -> Markup {
    let units = &summary.units;
    let demand = [("as printed", rule.printed), ("exact", rule.exact)];
    let rows: Vec<Vec<Markup>> = (demand.iter())
        .map(|(name, d)| {
            row([
                html! { (name) ", " (significant(d.constant, 4)) },
                html! { (significant(d.required_diameter_times_length, 4)) },
                html! { (significant(d.provided, 4)) },
                html! { (share(Some(d.required_diameter_times_length / d.provided))) },
                html! { (significant(d.required_length, 4)) },
                html! { (significant(rule.length, 4)) },
                met(d.met),
            ])
        })
        .collect();
    let caption = format!(
        "Diameter times length for {} {}, displaced by {} {}: (2-50), (2-51)",
        significant(rule.load, 4),
        units.force,
        significant(rule.displacement, 4),
        units.length
    );
    let (area, length) = (units.area(), &units.length);
    let asked = format!("D L asked for, {area}");
    let there = format!("there is, {area}");
    let length_asked = format!("L' asked for, {length}");
    let length_there = format!("there is, {length}");
    let headings = [
        "constant",
        &asked,
        &there,
        "used",
        &length_asked,
        &length_there,
        "met",
    ];
    table(&caption, &headings, &rows)
}

fn lines(sizing: &Sizing, summary: &Summary) -> Markup {
    let units = &summary.units;
    let rows: Vec<Vec<Markup>> = (sizing.lines.iter())
        .map(|line| {
            row([
                html! { (line.interface) },
                html! { (significant(line.across, 3)) @if line.merged { "*" } },
                html! { (significant(line.peak_line_load, 4)) },
                html! { (significant(line.from_end, 3)) },
                html! { (significant(line.hertz_pressure, 4)) },
                html! { (number(line.limit)) },
                html! { (share(line.utilisation)) },
                line.met.map_or_else(|| html! { "–" }, met),
                html! { (significant(line.even.line_load, 4)) },
                html! { (significant(line.even.hertz_pressure, 4)) },
                html! { (share(line.even.utilisation)) },
            ])
        })
        .collect();
    let pressure = format!("Hertz p0, {}", units.stress);
    let across = format!("across at, {}", units.length);
    let largest = format!("largest load, {}", units.line_load());
    let from_end = format!("from the end, {}", units.length);
    let even = format!("even load, {}", units.line_load());
    let headings = [
        "line of contact",
        &across,
        &largest,
        &from_end,
        &pressure,
        "limit",
        "of limit",
        "met",
        &even,
        &pressure,
        "of limit",
    ];
    html! {
        (table("Hertz's pressure within 1.65 times yield, (2-49)", &headings, &rows))
        @if sizing.lines.iter().any(|line| line.merged) {
            p class="note" { "* both lines of the V in one: the mesh is too coarse to tell them apart." }
        }
        p class="note" {
            "Under the largest load per length that each line carries, and under its force spread evenly over \
             the roller. Near the end of a roller the largest load is made by the end."
        }
    }
}
