//! The table on the terminal.

mod bodies;
mod certificate;
mod contact;
mod load_line;
mod sizing;
mod steps;
mod unloaded;

use super::left_out::{LeftOut, Saving};
use super::summary::{Reported, Summary};
use super::text::{Columns, percent, significant};
use crate::answer::Checks;
use bodies::{bodies, rollers};
use certificate::certificate;
use contact::{contact_lines, interfaces, line_loads, statics};
use load_line::load_line;
use sizing::sizing;
use std::fmt::Write;
use steps::{components, steps};
use unloaded::unloaded;

/// Digits of a figure that can be trusted, and of one that belongs to its mesh.
const DIGITS: usize = 4;
const SINGULAR_DIGITS: usize = 2;

/// The whole table, in the units of the case, every line ended; with `explain` it says what was
/// saved by each thing left out.
pub fn render(summary: &Summary, explain: bool) -> String {
    let sections = [
        header(summary),
        bodies(summary),
        rollers(summary),
        comparison(summary),
        interfaces(summary),
        line_loads(summary),
        contact_lines(summary),
        sizing(summary),
        statics(summary),
        steps(summary),
        load_line(summary),
        unloaded(summary),
        checks(&summary.answer.checks),
        certificate(summary),
        list("Assumed", summary.assumptions.iter()),
        left_out(&summary.left_out, explain),
        list("Warnings", summary.warnings.iter().map(|w| &w.0)),
    ];
    sections
        .into_iter()
        .filter(|s| !s.is_empty())
        .collect::<Vec<_>>()
        .join("\n")
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_string(), |v| significant(v, DIGITS))
}

fn header(summary: &Summary) -> String {
    let units = &summary.units;
    let state = if summary.answer.converged {
        "converged"
    } else {
        "NOT CONVERGED"
    };
    let mut text = format!("{}: {state}\n", summary.case);
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:<16}{value}");
    };
    if !summary.answer.step.is_empty() {
        line(
            "step",
            format!(
                "{}, {} done",
                summary.answer.step,
                percent(summary.answer.step_done)
            ),
        );
    }
    let load = significant(summary.answer.applied_load, DIGITS);
    line(
        "load",
        format!("{load} {}{}", units.force, oblique(summary)),
    );
    line(
        "descent",
        format!("{} {}", number(summary.answer.descent), units.length),
    );
    line(
        "largest strain",
        summary
            .answer
            .max_strain
            .map_or_else(|| "-".to_string(), percent),
    );
    let stiffness = format!("{}/{}", units.force, units.length);
    line(
        "stiffness",
        format!(
            "{} {stiffness}, load over descent",
            number(summary.answer.stiffness)
        ),
    );
    let (dofs, elements) = (summary.counters.dofs, summary.answer.elements);
    line("model", format!("{dofs} unknowns, {elements} elements"));
    let (iterations, factors) = (summary.counters.iterations, summary.counters.factorisations);
    line(
        "work",
        format!("{iterations} iterations, {factors} factorisations"),
    );
    let timing = &summary.timing;
    let time = format!(
        "{:.1} s (mesh {:.1} s, solution {:.1} s)",
        timing.total_s, timing.mesh_s, timing.solve_s
    );
    line("time", time);
    if let Some(bytes) = summary.peak_memory_bytes {
        line("peak memory", format!("{:.0} MB", bytes as f64 / 1e6));
    }
    text
}

/// The components of a load that is not along an axis, in brackets.
fn oblique(summary: &Summary) -> String {
    let components = components(summary.answer.applied_force);
    match components.iter().filter(|c| *c != "0").count() {
        0 | 1 => String::new(),
        _ => format!(" ({})", components.join(", ")),
    }
}

fn comparison(summary: &Summary) -> String {
    let headings = [
        "",
        "where",
        "this run",
        "report",
        "report-like mesh",
        "Hertz",
    ];
    let mut table = Columns::new(&headings);
    for row in &summary.comparison {
        let value = match (row.value, row.error) {
            (Some(value), _) if row.resolved == Some(false) => {
                format!("{}, unresolved", significant(value, SINGULAR_DIGITS))
            }
            (Some(_), Some(error)) => format!("{} ± {}", number(row.value), significant(error, 2)),
            (value, _) => number(value),
        };
        let report = match row.report {
            Some(Reported::Value(value)) => number(Some(value)),
            Some(Reported::Range([low, high])) => {
                format!("{} to {}", number(Some(low)), number(Some(high)))
            }
            None => "-".to_string(),
        };
        table.row([
            row.what.clone(),
            row.place.clone(),
            value,
            report,
            number(row.report_like),
            number(row.hertz),
        ]);
    }
    if table.is_empty() {
        String::new()
    } else {
        format!("Compared\n{}", table.render())
    }
}

fn checks(checks: &Checks) -> String {
    let mut table = Columns::new(&["Checks", ""]);
    for (name, value) in [
        ("force balance, of the load", checks.force_balance),
        (
            "penetration, of the descent",
            checks.max_penetration_relative,
        ),
        ("Coulomb violation, of μ p", checks.coulomb_violation),
        ("energy balance, of the work", checks.energy_imbalance),
        (
            "carried by stabilisation, of the load",
            checks.stabilisation_share,
        ),
    ] {
        let value = value.map_or_else(|| "not computed".to_string(), |v| format!("{v:.1e}"));
        table.row([name.to_string(), value]);
    }
    table.render().replacen("  Checks", "Checks", 1)
}

fn list<'a>(heading: &str, entries: impl Iterator<Item = &'a String>) -> String {
    let lines: String = entries.map(|entry| format!("  - {entry}\n")).collect();
    if lines.is_empty() {
        lines
    } else {
        format!("{heading}\n{lines}")
    }
}

fn left_out(items: &[LeftOut], explain: bool) -> String {
    let mut text = String::new();
    for item in items {
        let _ = writeln!(text, "  - {}", item.what);
        let saved: Vec<String> = item.saved.iter().map(Saving::to_string).collect();
        if explain && !saved.is_empty() {
            let _ = writeln!(text, "    saved: {}", saved.join(", "));
        }
    }
    match text.is_empty() {
        true => text,
        false => format!("Left out\n{text}"),
    }
}
