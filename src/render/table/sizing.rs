//! The sizing rules in the table.

use super::{DIGITS, number};
use crate::render::summary::{Demand, Sizing, SizingRule, Summary};
use crate::render::text::{Columns, percent, significant};

pub(super) fn sizing(summary: &Summary) -> String {
    let Some(sizing) = &summary.sizing else {
        return String::new();
    };
    let rule = sizing.rule.as_ref();
    let tables = [
        rule.map(|rule| demands(rule, summary)),
        lines(sizing, summary),
    ];
    let text: String = tables.into_iter().flatten().collect();
    match text.is_empty() {
        true => text,
        false => format!("Sizing rules (2-49) to (2-51)\n{text}"),
    }
}

fn said(met: bool) -> String {
    if met { "yes" } else { "NO" }.to_string()
}

fn demands(rule: &SizingRule, summary: &Summary) -> String {
    let units = &summary.units;
    let mut table = Columns::new(&[
        &format!(
            "D L for {} {} at D_r = {} {}",
            significant(rule.load, DIGITS),
            units.force,
            significant(rule.displacement, DIGITS),
            units.length
        ),
        &format!("required {}", units.area()),
        &format!("there is {}", units.area()),
        "met",
        &format!("L' required {}", units.length),
        &format!("there is {}", units.length),
    ]);
    let mut row = |name: &str, demand: &Demand| {
        table.row([
            format!("{name} constant, {}", significant(demand.constant, DIGITS)),
            significant(demand.required_diameter_times_length, DIGITS),
            significant(demand.provided, DIGITS),
            said(demand.met),
            significant(demand.required_length, DIGITS),
            significant(rule.length, DIGITS),
        ]);
    };
    row("printed", &rule.printed);
    row("exact", &rule.exact);
    table.render()
}

/// Each line: Hertz's pressure under its largest and under its even load.
fn lines(sizing: &Sizing, summary: &Summary) -> Option<String> {
    let units = &summary.units;
    let pressure = format!("p0 {}", units.stress);
    let mut table = Columns::new(&[
        "line of contact",
        "across at",
        &format!("largest {}", units.line_load()),
        "from end",
        &pressure,
        "limit",
        "of limit",
        "met",
        &format!("even {}", units.line_load()),
        &pressure,
        "of limit",
    ]);
    let dash = || "-".to_string();
    for line in &sizing.lines {
        table.row([
            line.interface.clone(),
            format!("{}{}", significant(line.across, 3), both(line.merged)),
            significant(line.peak_line_load, DIGITS),
            significant(line.from_end, 3),
            significant(line.hertz_pressure, DIGITS),
            number(line.limit),
            line.utilisation.map_or_else(dash, percent),
            line.met.map_or_else(dash, said),
            significant(line.even.line_load, DIGITS),
            significant(line.even.hertz_pressure, DIGITS),
            line.even.utilisation.map_or_else(dash, percent),
        ]);
    }
    let merged = sizing.lines.iter().any(|line| line.merged);
    let note = match merged {
        true => "  both: both lines of the V in one: the mesh is too coarse to tell them apart\n",
        false => "",
    };
    (!table.is_empty()).then(|| table.render() + note)
}

fn both(merged: bool) -> &'static str {
    if merged { ", both" } else { "" }
}
