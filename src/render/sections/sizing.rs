//! The sizing rules (2-49) to (2-51).

use crate::render::figures::{DIGITS, POSITION_DIGITS};
use crate::render::summary::{Sizing, SizingRule, Summary};
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

const RULES: &str = "Sizing rules (2-49) to (2-51)";
const LIMIT: &str = "Pressure limit (2-49)";
const PATCHES: &str = "Patches of contact and first yield";

/// What the rules ask for and what there is; then Hertz's pressure on each line of contact.
pub fn sizing(summary: &Summary) -> Vec<Table> {
    let Some(sizing) = &summary.sizing else {
        return Vec::new();
    };
    let mut tables: Vec<Table> = (sizing.rule.iter())
        .map(|rule| demands(rule, summary))
        .collect();
    let title = if tables.is_empty() { LIMIT } else { RULES };
    tables.push(lines(sizing, summary));
    if let Some(first) = tables.iter_mut().find(|table| !table.rows.is_empty()) {
        first.title = title.to_string();
    }
    tables.push(patches(sizing, summary));
    tables
}

/// Each patch: Hertz's pressure under its force, and that at which steel first yields below it.
fn patches(sizing: &Sizing, summary: &Summary) -> Table {
    let units = &summary.units;
    let mut table = Table::new(PATCHES)
        .words("patch of contact")
        .figure("force", &units.force)
        .figure("relative radii", &units.length)
        .wide()
        .figure("semi-axes", &units.length)
        .wide()
        .figure("p0", &units.stress)
        .figures(["first yield at", "of it"])
        .about("Hertz's elliptic contact under the force that each patch carries; first yield by Mises on its axis.");
    for patch in &sizing.patches {
        let both = |values: [f64; 2]| values.map(|v| significant(v, DIGITS)).join(", ");
        table.row([
            (&patch.interface).into(),
            Cell::figure(patch.force),
            both(patch.relative_radii).into(),
            both(patch.semi_axes).into(),
            Cell::figure(patch.hertz_pressure),
            Cell::figure(patch.first_yield),
            Cell::Share(patch.utilisation),
        ]);
        if let Some(why) = patch.not_hertz {
            table.note(format!("{} is no patch of Hertz's: {why}", patch.interface));
        }
    }
    table
}

fn demands(rule: &SizingRule, summary: &Summary) -> Table {
    let units = &summary.units;
    let mut table = Table::new("")
        .words(&format!(
            "D L for {} {} at D_r = {} {}",
            significant(rule.load, DIGITS),
            units.force,
            significant(rule.displacement, DIGITS),
            units.length
        ))
        .figure("required", units.area())
        .figure("there is", units.area())
        .figures(["used"])
        .wide()
        .figures(["met"])
        .figure("L' required", &units.length)
        .figure("there is", &units.length);
    for (name, demand) in [("printed", &rule.printed), ("exact", &rule.exact)] {
        let constant = significant(demand.constant, DIGITS);
        table.row([
            format!("{name} constant, {constant}").into(),
            Cell::figure(demand.required_diameter_times_length),
            Cell::figure(demand.provided),
            Cell::Share(Some(
                demand.required_diameter_times_length / demand.provided,
            )),
            Cell::Met(Some(demand.met)),
            Cell::figure(demand.required_length),
            Cell::figure(rule.length),
        ]);
    }
    table
}

/// Each line: Hertz's pressure under its largest and under its even load.
fn lines(sizing: &Sizing, summary: &Summary) -> Table {
    let units = &summary.units;
    let mut table = Table::new("")
        .words("line of contact")
        .figures(["across at"])
        .figure("largest", units.line_load())
        .figures(["from end"])
        .figure("p0", &units.stress)
        .figures(["limit", "of limit", "met"])
        .figure("even", units.line_load())
        .figure("p0", &units.stress)
        .figures(["of limit"])
        .about(
            "Under the largest load per length that each line carries, and under its force spread evenly over \
             the roller. Near the end of a roller the largest load is made by the end.",
        );
    for line in &sizing.lines {
        let across = significant(line.across, POSITION_DIGITS);
        table.row([
            (&line.interface).into(),
            format!("{across}{}", if line.merged { ", both" } else { "" }).into(),
            Cell::figure(line.peak_line_load),
            Cell::rough(line.from_end),
            Cell::figure(line.hertz_pressure),
            Cell::figure(line.limit),
            Cell::Share(line.utilisation),
            match line.verdict {
                Some(verdict) if verdict.is_within().is_none() => Cell::Care("open".to_owned()),
                _ => Cell::Met(line.met),
            },
            Cell::figure(line.even.line_load),
            Cell::figure(line.even.hertz_pressure),
            Cell::Share(line.even.utilisation),
        ]);
    }
    for line in &sizing.lines {
        if let Some(why) = line.not_hertz.filter(|_| !line.merged) {
            table.note(format!("{} is no strip of Hertz's: {why}", line.interface));
        }
    }
    if sizing.lines.iter().any(|line| line.merged) {
        table.note(
            "both: both lines of the V in one, which the mesh does not tell apart, or which press as one: largest is the \
             load of both and p0 as if one line carried it, even that of each",
        );
    }
    table
}
