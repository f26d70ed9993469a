//! Contact interfaces in the table.

use super::{DIGITS, number};
use crate::answer::InterfaceFigures;
use crate::render::summary::Summary;
use crate::render::text::{Columns, percent, place, significant};
use std::fmt::Write;

pub(super) fn interfaces(summary: &Summary) -> String {
    if summary.answer.interfaces.0.is_empty() {
        return String::new();
    }
    let units = &summary.units;
    let mut forces = Columns::new(&["interface", "along load", "share", "x", "y", "z", "∫p dA"]);
    let mut contact = Columns::new(&[
        "interface",
        &format!("p max {}", units.stress),
        "Hertz p0",
        &format!("area {}", units.area()),
        &format!("half-width {}", units.length),
        &format!("penetration {}", units.length),
        "of descent",
        "open/stick/slip",
    ]);
    for (name, interface) in &summary.answer.interfaces.0 {
        let share = interface.normal_force / summary.answer.applied_load;
        let mut row = vec![name.clone(), significant(interface.normal_force, DIGITS)];
        row.push(if share.is_finite() {
            percent(share)
        } else {
            "-".to_string()
        });
        row.extend(interface.force.map(|f| rounded(f, interface.normal_force)));
        row.push(significant(interface.pressure_integral, DIGITS));
        forces.row(row);
        contact.row(contact_row(name, interface, summary.answer.descent));
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

fn contact_row(name: &str, interface: &InterfaceFigures, descent: Option<f64>) -> Vec<String> {
    let relative = descent
        .filter(|d| *d != 0.0)
        .map(|d| interface.max_penetration / d.abs());
    let share = |share: Option<f64>| share.map_or_else(|| "-".to_string(), percent);
    let counts = &interface.status_counts;
    vec![
        name.to_string(),
        significant(interface.max_pressure, DIGITS),
        number(interface.hertz_p0),
        significant(interface.area, DIGITS),
        number(interface.half_width),
        significant(interface.max_penetration, 3),
        share(relative),
        format!("{}/{}/{}", counts.open, counts.stick, counts.slip),
    ]
}

/// Line loads of interfaces with the same slices stand under one heading.
pub(super) fn line_loads(summary: &Summary) -> String {
    let mut groups: Vec<(&[f64], Columns)> = Vec::new();
    for (name, interface) in &summary.answer.interfaces.0 {
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

/// Each line of contact: its largest load, and how far it carries.
pub(super) fn contact_lines(summary: &Summary) -> String {
    let units = &summary.units;
    let mut table = Columns::new(&[
        "line of contact",
        &format!("across at {}", units.length),
        "lines",
        &format!("largest load {}", units.line_load()),
        &format!("at {}", units.length),
        &format!("in contact {}", units.length),
        "lifted off",
    ]);
    for (name, interface) in &summary.answer.interfaces.0 {
        for line in &interface.lines {
            table.row([
                name.clone(),
                significant(line.across, 3),
                line.images.to_string(),
                significant(line.peak, DIGITS),
                significant(line.peak_at, 3),
                significant(line.length, 3),
                significant(line.lifted_off, 3),
            ]);
        }
    }
    match table.is_empty() {
        true => String::new(),
        false => table.render().replacen("  line of", "line of", 1),
    }
}

/// Where the resultants act, and what contact leaves unbalanced on bodies that nothing else holds.
pub(super) fn statics(summary: &Summary) -> String {
    let units = &summary.units;
    let mut centres = Columns::new(&[&format!("resultant acts at, {}", units.length), ""]);
    for (name, interface) in &summary.answer.interfaces.0 {
        let at = interface.centre_of_force;
        centres.row([name.clone(), at.map_or_else(|| "-".to_string(), place)]);
    }
    let moment = format!("{} {}", units.force, units.length);
    let mut balance = Columns::new(&[
        "held by contact alone",
        &format!("sum of forces, {}", units.force),
        &format!("of moments, {moment}"),
    ]);
    let largest = |v: &[f64; 3]| v.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    for (name, body) in &summary.answer.balance.0 {
        let [force, moment] = [&body.force, &body.moment].map(|v| format!("{:.1e}", largest(v)));
        balance.row([name.clone(), force, moment]);
    }
    let tables = [centres, balance].into_iter().filter(|t| !t.is_empty());
    let text: Vec<String> = tables
        .map(|t| t.render().trim_start().to_string())
        .collect();
    text.join("\n")
}
