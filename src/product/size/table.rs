//! A proposal on the terminal.

use super::proposal::Proposal;
use super::request::Rule;
use crate::ground::units::Dimension;
use crate::render::text::{Columns, percent, significant};
use std::fmt::Write;

/// The table of candidates, the choice and the assumptions, every line ended.
pub fn render(proposal: &Proposal) -> String {
    let text = [
        asked(proposal),
        lengths(proposal),
        pressures(proposal),
        choice(proposal),
        assumed(proposal),
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

fn marked(proposal: &Proposal, place: usize) -> &'static str {
    if proposal.recommended == Some(place) {
        " <"
    } else {
        ""
    }
}

fn digits(value: f64) -> String {
    // Sizes are practical numbers: no zeros behind them.
    let text = format!("{value:.6e}").parse::<f64>().unwrap_or(value);
    text.to_string()
}

fn lengths(proposal: &Proposal) -> String {
    let units = &proposal.units;
    let in_unit = |name: &str| format!("{name} {}", units.length);
    let (printed, exact) = match proposal.candidates.first() {
        Some(c) => (
            significant(c.printed.constant, 4),
            significant(c.exact.constant, 4),
        ),
        None => return String::new(),
    };
    let mut table = Columns::new(&[
        &in_unit("D"),
        &in_unit("wall"),
        &in_unit("plates"),
        &format!("L by {printed}"),
        &format!("L by {exact}"),
        &format!("L' by {printed}"),
        &format!("L' by {exact}"),
        "L' eccentric",
        &in_unit("L' taken"),
        "L'/D",
        &format!("steel {}", units.volume()),
    ]);
    for (place, c) in proposal.candidates.iter().enumerate() {
        table.row([
            digits(c.diameter),
            digits(c.wall),
            digits(c.plate),
            significant(c.printed.initial, 4),
            significant(c.exact.initial, 4),
            significant(c.printed.final_length, 4),
            significant(c.exact.final_length, 4),
            significant(c.eccentric_length, 4),
            digits(c.length),
            significant(c.slenderness, 3),
            significant(c.volume, 3) + marked(proposal, place),
        ]);
    }
    table.render()
        + "  L: (2-50) with the constant as printed and as it follows from (2-48), (2-49); L' = L + 2 D_r: \
           (2-51);\n  eccentric: the load of a displaced roller, rising linearly to the end that it \
           leans on, within (2-49)\n"
}

fn pressures(proposal: &Proposal) -> String {
    let units = &proposal.units;
    let mut table = Columns::new(&[
        &format!("D {}", units.length),
        &format!("even {}", units.line_load()),
        &format!("p0 {}", units.stress),
        "of limit",
        &format!("eccentric {}", units.line_load()),
        &format!("p0 {}", units.stress),
        "of limit",
        "slope deg",
        "at most",
        "rolls",
        "returns with",
        "rolling friction",
    ]);
    let request = &proposal.request;
    for (place, c) in proposal.candidates.iter().enumerate() {
        let linear = |read: &dyn Fn(&super::candidate::PressureSpread) -> String| {
            c.linear.as_ref().map_or_else(|| "-".to_string(), read)
        };
        table.row([
            digits(c.diameter),
            significant(c.even.line_load, 4),
            significant(c.even.pressure, 4),
            percent(c.even.utilisation),
            linear(&|p| significant(p.line_load, 4)),
            linear(&|p| significant(p.pressure, 4)),
            linear(&|p| percent(p.utilisation)),
            significant(request.slope.value.to_degrees(), 3),
            significant(c.largest_slope.to_degrees(), 3),
            (if c.rolls() { "yes" } else { "NO" }).to_string(),
            format!("{} W", significant(c.restoring_force, 2)),
            format!(
                "{} W{}",
                significant(c.rolling_friction, 2),
                marked(proposal, place)
            ),
        ]);
    }
    table.render()
        + "  p0: (2-48) under the load itself, of the limit (2-49); even: over L' - 2 D_r; slope at most: \
           (2-39);\n  returns with: (2-28); rolling friction: (2-3), (2-29); W: the weight carried\n"
}

fn choice(proposal: &Proposal) -> String {
    let Some(c) = proposal.choice() else {
        return format!("None is recommended:\n{}", wrapped(&proposal.why, 2));
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
    if proposal.request.rule.value != Rule::Eccentric
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

fn assumed(proposal: &Proposal) -> String {
    const INDENT: usize = 20;
    let mut text = String::from("Assumed (the option changes it)\n");
    for a in &proposal.assumptions {
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
