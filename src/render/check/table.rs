//! The check as a table on the terminal.

use super::{Check, Machine, PredictedCost};
use crate::render::table::text::text;
use crate::render::table::{Cell, Number, Table};
use crate::render::text::{list, significant};

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
    let verdict = if check.problems.is_empty() {
        "ready to run"
    } else {
        "a run would fail"
    };
    format!(
        "{}: {verdict}\n  mesh  {}: {} nodes, {} elements\n",
        check.case, check.mesh.source, check.mesh.nodes, check.mesh.elements
    )
}

fn bodies(check: &Check) -> String {
    let mut table = Table::new("")
        .words("Bodies")
        .figures(["elements", "nodes"])
        .figure("volume", check.units.volume())
        .figures(["scaled Jacobian >=", "aspect ratio <="]);
    let held = check.bodies.iter().map(|body| {
        let by = body.held_by.join("; ");
        let by = if by.is_empty() { "nothing" } else { &by };
        format!("{}: {by}", body.name)
    });
    for body in &check.bodies {
        table.row([
            (&body.name).into(),
            body.elements.into(),
            body.nodes.into(),
            Cell::figure(body.volume),
            format!("{:.3}", body.min_scaled_jacobian).into(),
            format!("{:.1}", body.max_aspect_ratio).into(),
        ]);
    }
    let held: Vec<String> = held.collect();
    format!("{}\n{}", text(&table), list("Held by", &held))
}

fn contacts(check: &Check) -> String {
    let length = &check.units.length;
    let [meshed, touch] = ["gap as meshed", "at first touch"].map(|h| format!("{h}, {length}"));
    let mut table = Table::new("")
        .words("Contacts")
        .figures(["friction", &meshed, &touch])
        .figures(["there", "nodes likely to close", "of"]);
    let gap = |gap: Option<f64>| Cell::Figure(Number::new(gap, 2));
    for contact in &check.contacts {
        table.row([
            (&contact.name).into(),
            Cell::rough(contact.friction),
            gap(contact.gap),
            gap(contact.gap_at_touch),
            Cell::Place(contact.at),
            contact.likely.into(),
            contact.within_reach.into(),
        ]);
    }
    text(&table)
}

fn strips(check: &Check) -> String {
    let units = &check.units;
    let mut table = Table::new("")
        .words("Lines of contact, Hertz, load spread evenly")
        .figures(["lines", &units.line_load()])
        .figures([
            format!("p0, {}", units.stress),
            format!("half-width a, {}", units.length),
            format!("nodes every h, {}", units.length),
        ])
        .figures(["a/h", "error of p0"]);
    for strip in &check.strips {
        let error = strip.pressure_error;
        table.row([
            (&strip.contact).into(),
            strip.lines.into(),
            Cell::figure(strip.line_load),
            Cell::figure(strip.peak_pressure),
            Cell::figure(strip.half_width),
            Cell::rough(strip.spacing),
            Cell::Figure(Number::new(strip.elements, 2)),
            error.map_or("unresolved".into(), |error| Cell::Share(Some(error))),
        ]);
    }
    text(&table)
}

fn cost(cost: &PredictedCost, machine: &Machine) -> String {
    let memory = match machine.memory_bytes {
        Some(bytes) => format!("{} left", gigabytes(bytes)),
        None => "what is left is not known".to_string(),
    };
    let [least, most] = cost.wall_s.map(seconds);
    let time = if least == most {
        format!("about {most}")
    } else {
        format!("{least} to {most}")
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
