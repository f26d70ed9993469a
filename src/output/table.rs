//! The table on the terminal.

use std::fmt::Write;

use super::left_out::{LeftOut, Saving};
use super::summary::{BodySummary, Checks, Figure, InterfaceSummary, Summary, Three};
use super::text::{Columns, percent, place, significant};

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
        checks(&summary.checks),
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
    let state = if summary.converged {
        "converged"
    } else {
        "NOT CONVERGED"
    };
    let mut text = format!("{}: {state}\n", summary.case);
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:<16}{value}");
    };
    if !summary.step.is_empty() {
        line(
            "step",
            format!("{}, {} done", summary.step, percent(summary.step_done)),
        );
    }
    line(
        "load",
        format!(
            "{} {}",
            significant(summary.applied_load, DIGITS),
            units.force
        ),
    );
    line(
        "descent",
        format!("{} {}", number(summary.descent), units.length),
    );
    line(
        "largest strain",
        summary.max_strain.map_or_else(|| "-".to_string(), percent),
    );
    let (dofs, elements) = (summary.dofs, summary.elements);
    line("model", format!("{dofs} unknowns, {elements} elements"));
    let (iterations, factors) = (summary.iterations, summary.factorisations);
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

fn bodies(summary: &Summary) -> String {
    let mut table = Columns::new(&[
        "body",
        "centroid",
        "integration pt",
        "nodal",
        "plastic strain",
        &format!("yielded {}", summary.units.volume()),
    ]);
    let mut places = Columns::new(&["where", "centroid", "integration pt", "nodal"]);
    let mut singular = false;
    for (name, body) in &summary.bodies.0 {
        singular |= body.at_singular_edge.each().contains(&true);
        let mut row = vec![name.clone()];
        row.extend(peaks(&body.mises_max, &body.at_singular_edge));
        row.push(significant(body.peeq_max, 3));
        row.push(significant(body.yielded_volume, 3));
        table.row(row);
        if let Some(elastic) = elastic_row(body) {
            table.row(elastic);
        }
        let at = body
            .at
            .each()
            .map(|at| at.map_or_else(|| "-".to_string(), place));
        places.row(std::iter::once(name.clone()).chain(at));
    }
    if table.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "Largest Mises stress, {}\n{}",
        summary.units.stress,
        table.render()
    );
    if singular {
        text.push_str("  * beside a loaded edge: a value of this mesh, see the warnings\n");
    }
    format!(
        "{text}\nPeaks at, {}\n{}",
        summary.units.length,
        places.render()
    )
}

fn peaks(values: &Three<Option<f64>>, singular: &Three<bool>) -> Vec<String> {
    let digits = |singular| if singular { SINGULAR_DIGITS } else { DIGITS };
    let print = |(value, singular): (Option<f64>, bool)| match value {
        Some(value) => {
            format!(
                "{}{}",
                significant(value, digits(singular)),
                if singular { "*" } else { "" }
            )
        }
        None => "-".to_string(),
    };
    values
        .each()
        .into_iter()
        .zip(singular.each())
        .map(print)
        .collect()
}

fn elastic_row(body: &BodySummary) -> Option<Vec<String>> {
    let elastic = body.elastic_mises_max?;
    let mut row = vec!["  elastic".to_string()];
    row.extend(peaks(&elastic, &body.at_singular_edge));
    Some(row)
}

fn rollers(summary: &Summary) -> String {
    let mut table = Columns::new(&["roller", "from strain", "at", "nodal", "at"]);
    let at = |at: Option<[f64; 3]>| at.map_or_else(|| "-".to_string(), place);
    for (name, roller) in &summary.rollers.0 {
        table.row([
            name.clone(),
            number(roller.bore_mises),
            at(roller.bore_mises_at),
            number(roller.bore_mises_nodal),
            at(roller.bore_mises_nodal_at),
        ]);
    }
    if table.is_empty() {
        return String::new();
    }
    format!(
        "Mises stress at the bore, {}\n{}",
        summary.units.stress,
        table.render()
    )
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
            (Some(_), Some(error)) => format!("{} ± {}", number(row.value), significant(error, 2)),
            (value, _) => number(value),
        };
        let report = match row.report {
            Some(Figure::Value(value)) => number(Some(value)),
            Some(Figure::Range([low, high])) => {
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

fn interfaces(summary: &Summary) -> String {
    if summary.interfaces.0.is_empty() {
        return String::new();
    }
    let units = &summary.units;
    let mut forces = Columns::new(&["interface", "along load", "share", "x", "y", "z", "∫p dA"]);
    let mut contact = Columns::new(&[
        "interface",
        &format!("p max {}", units.stress),
        &format!("area {}", units.area()),
        &format!("half-width {}", units.length),
        &format!("penetration {}", units.length),
        "of descent",
        "of element",
        "open/stick/slip",
    ]);
    for (name, interface) in &summary.interfaces.0 {
        let share = interface.normal_force / summary.applied_load;
        let mut row = vec![name.clone(), significant(interface.normal_force, DIGITS)];
        row.push(if share.is_finite() {
            percent(share)
        } else {
            "-".to_string()
        });
        row.extend(interface.force.map(|f| rounded(f, interface.normal_force)));
        row.push(significant(interface.pressure_integral, DIGITS));
        forces.row(row);
        contact.row(contact_row(name, interface, summary.descent));
    }
    format!(
        "Force on the lower body, {}\n{}\nContact\n{}",
        units.force,
        forces.render(),
        contact.render()
    )
}

/// A component of a force, as zero where it is noise beside the whole.
fn rounded(component: f64, whole: f64) -> String {
    if component.abs() < 1e-9 * whole.abs() {
        return "0".to_string();
    }
    significant(component, DIGITS)
}

fn contact_row(name: &str, interface: &InterfaceSummary, descent: Option<f64>) -> Vec<String> {
    let relative = descent
        .filter(|d| *d != 0.0)
        .map(|d| interface.max_penetration / d.abs());
    let share = |share: Option<f64>| share.map_or_else(|| "-".to_string(), percent);
    let counts = &interface.status_counts;
    vec![
        name.to_string(),
        significant(interface.max_pressure, DIGITS),
        significant(interface.area, DIGITS),
        number(interface.half_width),
        significant(interface.max_penetration, 3),
        share(relative),
        share(interface.penetration_per_element),
        format!("{}/{}/{}", counts.open, counts.stick, counts.slip),
    ]
}

/// Line loads of interfaces with the same slices stand under one heading.
fn line_loads(summary: &Summary) -> String {
    let mut groups: Vec<(&[f64], Columns)> = Vec::new();
    for (name, interface) in &summary.interfaces.0 {
        let Some(q) = &interface.q else { continue };
        let known = groups
            .iter()
            .position(|(edges, _)| *edges == q.edges.as_slice());
        let group = known.unwrap_or_else(|| {
            let mut headings = vec!["slice ends".to_string()];
            headings.extend(q.edges.iter().skip(1).map(|e| format!("{e:.2}")));
            let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
            groups.push((&q.edges, Columns::new(&headings)));
            groups.len() - 1
        });
        let label = format!("{name}, along {}", q.axis);
        let values = q.values.iter().map(|v| significant(*v, 3));
        groups[group].1.row(std::iter::once(label).chain(values));
    }
    let mut text = String::new();
    for (edges, table) in groups {
        let start = edges
            .first()
            .map_or_else(String::new, |e| format!("{e:.2}"));
        let unit = summary.units.line_load();
        let _ = write!(
            text,
            "Line load from {start} on, {unit}\n{}",
            table.render()
        );
    }
    text
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
