//! The check as a table on the terminal.

use super::{Check, Cost, Machine};
use crate::render::text::{Columns, percent, place, significant};

/// The whole table, every line ended.
pub fn render(check: &Check) -> String {
    let sections = [
        header(check),
        bodies(check),
        contacts(check),
        strips(check),
        cost(&check.cost, &check.machine),
        list("Needed", &check.needs),
        list("Left out", &check.left_out),
        list("Assumed", &check.assumptions),
        list("Limits that the answer is held to", &check.limits),
        list("Warnings", &check.warnings),
        list("PROBLEMS", &check.problems),
    ];
    let filled: Vec<String> = sections.into_iter().filter(|s| !s.is_empty()).collect();
    filled.join("\n")
}

fn header(check: &Check) -> String {
    let verdict = match check.problems.is_empty() {
        true => "ready to run",
        false => "a run would fail",
    };
    format!(
        "{}: {verdict}\n  mesh  {}: {} nodes, {} elements\n",
        check.case, check.mesh.source, check.mesh.nodes, check.mesh.elements
    )
}

fn bodies(check: &Check) -> String {
    let volume = format!("volume {}", check.units.volume());
    let mut table = Columns::new(&[
        "Bodies",
        "elements",
        "nodes",
        &volume,
        "scaled Jacobian >=",
        "aspect ratio <=",
    ]);
    let mut held = String::from("Held by\n");
    for body in &check.bodies {
        table.row([
            body.name.clone(),
            body.elements.to_string(),
            body.nodes.to_string(),
            significant(body.volume, 4),
            format!("{:.3}", body.min_scaled_jacobian),
            format!("{:.1}", body.max_aspect_ratio),
        ]);
        let by = match body.held_by.is_empty() {
            true => "nothing".to_string(),
            false => body.held_by.join("; "),
        };
        held.push_str(&format!("  - {}: {by}\n", body.name));
    }
    format!("{}\n{held}", headed(&table, "Bodies"))
}

fn contacts(check: &Check) -> String {
    let length = &check.units.length;
    let [meshed, touch] = ["gap as meshed", "at first touch"].map(|h| format!("{h}, {length}"));
    let mut table = Columns::new(&[
        "Contacts",
        "friction",
        &meshed,
        &touch,
        "there",
        "nodes likely to close",
        "of",
    ]);
    let gap = |gap: Option<f64>| gap.map_or_else(|| "-".to_string(), |gap| significant(gap, 2));
    for contact in &check.contacts {
        table.row([
            contact.name.clone(),
            significant(contact.friction, 3),
            gap(contact.gap),
            gap(contact.gap_at_touch),
            contact.at.map_or_else(|| "-".to_string(), place),
            contact.likely.to_string(),
            contact.within_reach.to_string(),
        ]);
    }
    match table.is_empty() {
        true => String::new(),
        false => headed(&table, "Contacts"),
    }
}

fn strips(check: &Check) -> String {
    let units = &check.units;
    let mut table = Columns::new(&[
        "Lines of contact, Hertz, load spread evenly",
        "lines",
        &units.line_load(),
        &format!("p0, {}", units.stress),
        &format!("half-width a, {}", units.length),
        &format!("nodes every h, {}", units.length),
        "a/h",
        "error of p0",
    ]);
    for strip in &check.strips {
        table.row([
            strip.contact.clone(),
            strip.lines.to_string(),
            significant(strip.line_load, 4),
            significant(strip.peak_pressure, 4),
            significant(strip.half_width, 4),
            significant(strip.spacing, 3),
            significant(strip.elements, 2),
            (strip.pressure_error).map_or_else(|| "unresolved".to_string(), percent),
        ]);
    }
    match table.is_empty() {
        true => String::new(),
        false => headed(&table, "Lines of contact"),
    }
}

fn cost(cost: &Cost, machine: &Machine) -> String {
    let memory = match machine.memory_bytes {
        Some(bytes) => format!("{} left", gigabytes(bytes)),
        None => "what is left is not known".to_string(),
    };
    let [least, most] = cost.wall_s.map(seconds);
    let time = match least == most {
        true => format!("about {most}"),
        false => format!("{least} to {most}"),
    };
    format!(
        "Cost, estimated\n  \
         unknowns   {}, contact acts on {} of them\n  \
         solver     {}\n  \
         memory     {}; {memory}\n  \
         time       {time} on {} threads, a rough figure: about {:.0} iterations\n",
        cost.unknowns,
        cost.contact_unknowns,
        cost.solver,
        gigabytes(cost.memory_bytes),
        machine.threads,
        cost.iterations,
    )
}

fn gigabytes(bytes: f64) -> String {
    format!("{} GB", significant(1e-9 * bytes, 2))
}

fn seconds(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "1 s".to_string(),
        s if s < 90.0 => format!("{s:.0} s"),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.0} h", s / 3600.0),
    }
}

fn list(heading: &str, entries: &[String]) -> String {
    let lines: String = entries
        .iter()
        .map(|entry| format!("  - {entry}\n"))
        .collect();
    match lines.is_empty() {
        true => lines,
        false => format!("{heading}\n{lines}"),
    }
}

/// The table, its first heading flush with the margin.
fn headed(table: &Columns, heading: &str) -> String {
    (table.render()).replacen(&format!("  {heading}"), heading, 1)
}
