//! All of a run on the terminal: a head, the tables of its sections, and what to know of it in words.

use super::figures::DIGITS;
use super::left_out::{LeftOut, Saving};
use super::sections;
use super::summary::Summary;
use super::table::text::{text, texts};
use super::text::{list, percent, significant};
use crate::answer::Answer;
use crate::ground::geometry::norm;
use crate::render::table::Table;
use std::fmt::Write;

/// Everything, in the units of the case, every line ended; with `explain` it says what was saved by each thing left
/// out.
pub fn tables(summary: &Summary, explain: bool) -> String {
    // Tables that belong together follow each other without a blank line.
    let together = |tables: Vec<Table>| tables.iter().map(text).collect::<String>();
    let unloaded: Vec<Table> = sections::unloaded(summary).into_iter().collect();
    let sections = [
        header(summary),
        texts(&sections::bodies(summary)),
        text(&sections::compared(summary)),
        texts(&sections::contact(summary)),
        texts(&sections::ties(summary)),
        together(sections::slices(summary)),
        text(&sections::lines(summary)),
        together(sections::sizing(summary)),
        texts(&sections::rules(summary)),
        texts(&sections::statics(summary)),
        text(&sections::steps(summary)),
        text(&sections::load_line(summary)),
        texts(&unloaded),
        text(&sections::checks(summary)),
        text(&sections::certificate(summary)),
        text(&sections::hand_checks(summary)),
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

/// Whether a solution has come to its end, in a word or two.
pub fn how_it_ended(answer: &Answer) -> &'static str {
    match (answer.converged, answer.interrupted) {
        (true, _) => "converged",
        (false, true) => "INTERRUPTED",
        (false, false) => "NOT CONVERGED",
    }
}

/// The case and whether it has converged, a line.
pub fn headline(summary: &Summary) -> String {
    format!("{}: {}\n", summary.case, how_it_ended(&summary.answer))
}

fn header(summary: &Summary) -> String {
    let units = &summary.units;
    let mut text = headline(summary);
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
    /// Components below this share of the whole are rounding.
    const NOISE: f64 = 1e-9;
    let force = summary.answer.applied_force;
    let whole = norm(force);
    let along = force.map(|f| if f.abs() <= NOISE * whole { 0.0 } else { f });
    if along.iter().filter(|f| **f != 0.0).count() < 2 {
        return String::new();
    }
    format!(" ({})", along.map(|f| significant(f, DIGITS)).join(", "))
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
    if text.is_empty() {
        text
    } else {
        format!("Left out\n{text}")
    }
}
