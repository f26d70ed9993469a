//! Load and descent at the ends of the steps, and what stays after unloading.

use crate::answer::Unloaded;
use crate::render::report::figures::number;
use crate::render::report::html::{row, table};
use crate::render::summary::Summary;
use crate::render::text::{place, significant};
use maud::{Markup, html};

pub fn loading(summary: &Summary) -> Markup {
    let units = &summary.units;
    let mut before = (0.0, Some(0.0));
    let rows: Vec<Vec<Markup>> = (summary.answer.load_line.iter())
        .map(|point| {
            let slope = point
                .descent
                .zip(before.1)
                .map(|(now, then)| (point.load - before.0) / (now - then));
            before = (point.load, point.descent);
            row([
                html! { (point.step) },
                html! { (significant(point.load, 4)) },
                html! { (number(point.descent)) },
                html! { (number(slope.filter(|s| s.is_finite()))) },
            ])
        })
        .collect();
    let load = format!("load, {}", units.force);
    let descent = format!("descent, {}", units.length);
    let slope = format!("slope, {}/{}", units.force, units.length);
    html! {
        (table("", &["end of step", &load, &descent, &slope], &rows))
        @if summary.answer.steps.len() > 1 { (steps(summary)) }
        @if let Some(unloaded) = &summary.answer.unloaded { (stays(unloaded, summary)) }
    }
}

/// All steps at their ends, the one that the page is of in bold.
fn steps(summary: &Summary) -> Markup {
    let units = &summary.units;
    let rows: Vec<Vec<Markup>> = (summary.answer.steps.iter())
        .map(|step| {
            let [stick, slip] = step.stick_and_slip();
            let [x, y, z] = step.force.map(|f| significant(f, 4));
            row([
                html! { @if step.reported { b { (step.name) } } @else { (step.name) } },
                html! { (x) },
                html! { (y) },
                html! { (z) },
                html! { (number(step.mises_max.nodal)) },
                html! { (number(step.max_pressure())) },
                html! { (significant(step.peeq_max, 3)) },
                html! { (stick) "/" (slip) },
            ])
        })
        .collect();
    let force = |axis: &str| format!("load {axis}, {}", units.force);
    let stress = |what: &str| format!("{what}, {}", units.stress);
    let (x, y, z) = (force("x"), force("y"), force("z"));
    let (mises, pressure) = (stress("Mises, nodal"), stress("p max"));
    let headings = [
        "end of step",
        &x,
        &y,
        &z,
        &mises,
        &pressure,
        "plastic strain",
        "sticking/slipping nodes",
    ];
    html! {
        (table("All steps", &headings, &rows))
        p class="note" {
            "All other figures and pictures are of step “" (summary.answer.step) "”"
            @if summary.answer.unloaded.is_some() { ", the last before unloading" }
            "."
        }
    }
}

fn stays(unloaded: &Unloaded, summary: &Summary) -> Markup {
    let units = &summary.units;
    let rows: Vec<Vec<Markup>> = (unloaded.dents.0.iter())
        .map(|(surface, dent)| {
            row([
                html! { (surface) },
                html! { (dent.body) },
                html! { (significant(dent.depth, 3)) },
                html! { (place(dent.at)) },
            ])
        })
        .collect();
    let caption = format!(
        "Dents that stay, at {} {}",
        significant(unloaded.applied_load, 3),
        units.force
    );
    let depth = format!("depth, {}", units.length);
    let at = format!("at, {}", units.length);
    html! {
        (table(&caption, &["surface", "<body", &depth, &at], &rows))
        @if !unloaded.elastic_removed {
            p class="note" { "What the load that is left presses elastically is still in them." }
        }
    }
}
