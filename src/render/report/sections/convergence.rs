//! The history of the solution: what every iteration told.

use crate::render::plot::{Line, Panel, PlotFigure, Scale, charts};
use crate::render::report::Inputs;
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
        (charts([&residuals(history), &contact(history)]))
        details { summary { (history.len()) " iterations, as they were printed" } (table(&rows(history))) }
    }
}

/// What every iteration says of one thing.
type Reading = (&'static str, fn(&Iterate) -> f64);

fn figure(
    history: &[Iterate],
    title: &str,
    up: &str,
    scale: Scale,
    readings: &[Reading],
) -> PlotFigure {
    let line = |(style, (_, read)): (usize, &Reading)| {
        let points = (1..).zip(history).map(|(k, i)| (f64::from(k), read(i)));
        // On a logarithmic axis, what is far below any tolerance is as good as zero.
        let shown = |p: &(f64, f64)| scale == Scale::Linear || p.1 >= FLOOR;
        Line::dotted(style, points.filter(shown).collect())
    };
    let axes = ["iteration".to_string(), up.to_string()];
    let lines = readings.iter().enumerate().map(line).collect();
    let panel = Panel::new(title.to_string(), axes, scale, lines);
    let names = readings.iter().map(|(name, _)| (*name).to_string());
    PlotFigure::single(panel, names.collect())
}

const FLOOR: f64 = 1e-16;

fn residuals(history: &[Iterate]) -> PlotFigure {
    let readings: [Reading; 3] = [
        ("residual force over applied force", |i| i.residual),
        ("contact violation over largest displacement", |i| {
            i.violation
        }),
        ("work of the correction over that of the load", |i| {
            i.energy.abs()
        }),
    ];
    let title = "Residual, gap and energy";
    figure(history, title, "relative", Scale::DecadesUp, &readings)
}

fn contact(history: &[Iterate]) -> PlotFigure {
    let readings: [Reading; 5] = [
        ("pressing", |i| i.active as f64),
        ("slipping", |i| i.slipping as f64),
        ("sticking", |i| i.sticking as f64),
        ("integration points that flow", |i| i.flowing as f64),
        ("changed", |i| i.changed as f64),
    ];
    let title = "Contact nodes, and plastic flow";
    figure(history, title, "number", Scale::Linear, &readings)
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
