//! A proposal on the terminal.

use super::assumption::SizingAssumption;
use super::proposal::Proposal;
use super::request::LengthRule;
use crate::ground::units::Dimension;
use crate::render::table::text::text;
use crate::render::table::{Cell, Table};
use crate::render::text::{percent, significant};
use std::fmt::Write;

/// The table of candidates, the choice and the assumptions, every line ended.
pub fn render(proposal: &Proposal) -> String {
    let text = [
        asked(proposal),
        lengths(proposal),
        pressures(proposal),
        choice(proposal),
        assumed(&proposal.assumptions),
    ];
    text.join("\n")
}

fn asked(proposal: &Proposal) -> String {
    let r = &proposal.request;
    let show = |value, dimension| r.units.show(value, dimension);
    format!(
        "Sized for {}, steel of {}, displacement 2 D_r = {}\n",
        show(r.load, Dimension::FORCE),
        show(r.yield_stress, Dimension::STRESS),
        show(r.capacity, Dimension::LENGTH)
    )
}

/// The mark of the recommended row, behind another one nothing.
pub(super) fn mark(recommended: Option<usize>, place: usize) -> &'static str {
    match recommended == Some(place) {
        true => " <",
        false => "",
    }
}

/// Why no row is recommended.
pub(super) fn none_recommended(why: &str) -> String {
    format!("None is recommended:\n{}", wrapped(why, 2))
}

pub(super) fn digits(value: f64) -> String {
    // Sizes are practical numbers: no zeros behind them.
    let text = format!("{value:.6e}").parse::<f64>().unwrap_or(value);
    text.to_string()
}

fn lengths(proposal: &Proposal) -> String {
    let units = &proposal.units;
    let (printed, exact) = match proposal.candidates.first() {
        Some(c) => (
            significant(c.printed.constant, 4),
            significant(c.exact.constant, 4),
        ),
        None => return String::new(),
    };
    let mut table = Table::new("")
        .figure("D", &units.length)
        .figure("wall", &units.length)
        .figure("plates", &units.length)
        .figures([format!("L by {printed}"), format!("L by {exact}")])
        .figures([format!("L' by {printed}"), format!("L' by {exact}")])
        .figures(["L' eccentric"])
        .figure("L' taken", &units.length)
        .figures(["L'/D"])
        .figure("steel", units.volume());
    for (place, c) in proposal.candidates.iter().enumerate() {
        table.row([
            digits(c.diameter).into(),
            digits(c.wall).into(),
            digits(c.plate).into(),
            Cell::figure(c.printed.initial),
            Cell::figure(c.exact.initial),
            Cell::figure(c.printed.final_length),
            Cell::figure(c.exact.final_length),
            Cell::figure(c.eccentric_length),
            digits(c.length).into(),
            Cell::rough(c.slenderness),
            (significant(c.volume, 3) + mark(proposal.recommended, place)).into(),
        ]);
    }
    table.note(
        "L: (2-50) with the constant as printed and as it follows from (2-48), (2-49); L' = L + 2 D_r: (2-51);",
    );
    table.note(
        "eccentric: the load of a displaced roller, rising linearly to the end that it leans on, within (2-49)",
    );
    text(&table)
}

fn pressures(proposal: &Proposal) -> String {
    let units = &proposal.units;
    let mut table = Table::new("")
        .figure("D", &units.length)
        .figure("even", units.line_load())
        .figure("p0", &units.stress)
        .figures(["of limit"])
        .figure("eccentric", units.line_load())
        .figure("p0", &units.stress)
        .figures(["of limit", "slope deg", "at most", "rolls"])
        .figures(["returns with", "rolling friction"]);
    for (place, c) in proposal.candidates.iter().enumerate() {
        let weight = |share: f64| format!("{} W", significant(share, 2));
        table.row([
            digits(c.diameter).into(),
            Cell::figure(c.even.line_load),
            Cell::figure(c.even.pressure),
            Cell::Share(Some(c.even.utilisation)),
            Cell::figure(c.linear.map(|p| p.line_load)),
            Cell::figure(c.linear.map(|p| p.pressure)),
            Cell::Share(c.linear.map(|p| p.utilisation)),
            Cell::rough(proposal.request.slope.value.to_degrees()),
            Cell::rough(c.largest_slope.to_degrees()),
            Cell::Met(Some(c.rolls())),
            weight(c.restoring_force).into(),
            (weight(c.rolling_friction) + mark(proposal.recommended, place)).into(),
        ]);
    }
    table.note(
        "p0: (2-48) under the load itself, of the limit (2-49); even: over L' - 2 D_r; slope at most: (2-39);",
    );
    table.note("returns with: (2-28); rolling friction: (2-3), (2-29); W: the weight carried");
    text(&table)
}

fn choice(proposal: &Proposal) -> String {
    let Some(c) = proposal.choice() else {
        return none_recommended(&proposal.why);
    };
    let show = |value| proposal.request.units.show(value, Dimension::LENGTH);
    let mut text = format!(
        "Recommended (<): rollers {} x {}, wall {}, plates {}\n{}",
        show(c.diameter),
        show(c.length),
        show(c.wall),
        show(c.plate),
        wrapped(&proposal.why, 2)
    );
    if proposal.request.rule.value != LengthRule::Eccentric
        && c.linear.is_none_or(|p| p.utilisation > 1.0)
    {
        let pressed = c.linear.map_or("the load passes its end".to_string(), |p| {
            format!("p0 is {} of the limit by statics", percent(p.utilisation))
        });
        text += &wrapped(
            &format!(
                "beware: displaced, it leans on its end: {pressed}; --rule eccentric allows for it"
            ),
            2,
        );
    }
    text
}

pub(super) fn assumed(assumptions: &[SizingAssumption]) -> String {
    const INDENT: usize = 20;
    let mut text = String::from("Assumed (the option changes it)\n");
    for a in assumptions {
        let given = if a.given { ", as asked" } else { "" };
        let words = format!("{}{given}: {}", a.value, a.why);
        let mut lines = wrapped(&words, INDENT);
        lines.replace_range(2..2 + a.option.len(), a.option);
        text += &lines;
    }
    text
}

/// `text` in lines of at most a hundred columns, each indented and ended.
pub(super) fn wrapped(text: &str, indent: usize) -> String {
    const WIDTH: usize = 100;
    let mut lines = String::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && indent + line.chars().count() + 1 + word.chars().count() > WIDTH {
            // Writing to a string cannot fail.
            let _ = writeln!(lines, "{:indent$}{line}", "");
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    let _ = writeln!(lines, "{:indent$}{line}", "");
    lines
}
