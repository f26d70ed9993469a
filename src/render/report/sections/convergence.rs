//! The history of the solution: what every iteration told.

use crate::render::report::Inputs;
use crate::render::report::drawing::axes::Axis;
use crate::render::report::drawing::chart::{Chart, Mark, Series, decades, from_zero};
use crate::render::report::history::Iterate;
use crate::render::table::html::table;
use crate::render::table::{Cell, Table};
use maud::{Markup, html};

pub fn convergence(inputs: &Inputs) -> Markup {
    let history = inputs.history;
    if history.is_empty() {
        return Markup::default();
    }
    html! {
        p class="note" {
            "Iterations of this run one after the other; with every increment the residual starts high again. The \
             second solution without plasticity is not among them."
        }
        div class="pair" { (residuals(history).draw()) (contact(history).draw()) }
        details { summary { (history.len()) " iterations, as they were printed" } (table(&rows(history))) }
    }
}

fn series(
    history: &[Iterate],
    (name, colour): (&str, usize),
    read: impl Fn(&Iterate) -> f64,
) -> Series {
    let points = (1..).zip(history).map(|(k, i)| (f64::from(k), read(i)));
    Series {
        name: name.to_string(),
        mark: Mark::LineAndDots,
        colour,
        points: points.collect(),
    }
}

fn along(history: &[Iterate]) -> Axis {
    Axis::linear("iteration", 0.0..history.len() as f64 + 1.0)
}

fn residuals(history: &[Iterate]) -> Chart {
    let series = vec![
        series(history, ("residual force over applied force", 0), |i| {
            i.residual
        }),
        series(
            history,
            ("contact violation over largest displacement", 1),
            |i| i.violation,
        ),
        series(
            history,
            ("work of the correction over that of the load", 2),
            |i| i.energy.abs(),
        ),
    ];
    // What is far below any tolerance is as good as zero.
    const FLOOR: f64 = 1e-16;
    let shown = series
        .iter()
        .flat_map(|s| s.points.iter().map(|p| p.1.max(FLOOR)));
    let range = decades(shown);
    Chart {
        title: "Residual, gap and energy".to_string(),
        axes: [along(history), Axis::decades("relative", range)],
        series,
    }
}

fn contact(history: &[Iterate]) -> Chart {
    let count = |n: usize| n as f64;
    let series = vec![
        series(history, ("pressing", 0), |i| count(i.active)),
        series(history, ("sticking", 2), |i| count(i.sticking)),
        series(history, ("slipping", 1), |i| count(i.slipping)),
        series(history, ("changed", 5), |i| count(i.changed)),
        series(history, ("integration points that flow", 3), |i| {
            count(i.flowing)
        }),
    ];
    let largest = from_zero(series.iter().flat_map(|s| s.points.iter().map(|p| p.1)));
    Chart {
        title: "Contact nodes, and plastic flow".to_string(),
        axes: [along(history), Axis::linear("number", largest)],
        series,
    }
}

fn rows(history: &[Iterate]) -> Table {
    let mut table = Table::new("").figures([
        "load",
        "iteration",
        "residual",
        "energy",
        "pressing",
        "stick",
        "slip",
        "changed",
        "violation",
        "flowing",
        "directions",
        "line search",
    ]);
    for i in history {
        let factor = if i.refactored { ", new factor" } else { "" };
        table.row([
            format!("{:.3}", i.load).into(),
            i.iteration.into(),
            Cell::Tiny(i.residual),
            Cell::Tiny(i.energy),
            i.active.into(),
            i.sticking.into(),
            i.slipping.into(),
            i.changed.into(),
            Cell::Tiny(i.violation),
            i.flowing.into(),
            format!("{}{factor}", i.directions).into(),
            format!("{:.2}", i.line_search).into(),
        ]);
    }
    table
}
