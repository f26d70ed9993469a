//! A proposal of parallel rollers on the terminal.

use super::proposal::LineProposal;
use crate::ground::units::Dimension;
use crate::product::size::table::{assumed, digits, mark, none_recommended, wrapped};
use crate::render::table::text::text;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

/// The table of candidates, the choice and the assumptions, every line ended.
pub fn render(proposal: &LineProposal) -> String {
    let request = &proposal.request;
    let show = |value, dimension| request.units.show(value, dimension);
    let asked = format!(
        "Parallel rollers for {}, steel of {}\n",
        show(request.load, Dimension::FORCE),
        show(request.yield_stress, Dimension::STRESS)
    );
    let parts = [
        asked,
        candidates(proposal),
        choice(proposal),
        assumed(&proposal.assumptions),
    ];
    parts.join("\n")
}

fn candidates(proposal: &LineProposal) -> String {
    let units = &proposal.units;
    let mut table = Table::new("")
        .figures(["rollers"])
        .figure("D", &units.length)
        .figure("plates", &units.length)
        .figure("L asked", &units.length)
        .figure("L taken", &units.length)
        .figures(["L/D"])
        .figure("even", units.line_load())
        .figure("p0", &units.stress)
        .figures(["of limit"])
        .figure("steel", units.volume());
    for (place, c) in proposal.candidates.iter().enumerate() {
        table.row([
            c.rollers.to_string().into(),
            digits(c.diameter).into(),
            digits(c.plate).into(),
            Cell::figure(c.required_length),
            digits(c.length).into(),
            Cell::rough(c.slenderness),
            Cell::figure(c.even.line_load),
            Cell::figure(c.even.pressure),
            Cell::Share(Some(c.even.utilisation)),
            (significant(c.volume, 3) + mark(proposal.recommended, place)).into(),
        ]);
    }
    table.note("L asked: for the load times its margin; p0: (2-48) under the load itself, spread evenly, of the limit (2-49)");
    text(&table)
}

fn choice(proposal: &LineProposal) -> String {
    let Some(c) = proposal.choice() else {
        return none_recommended(&proposal.why);
    };
    let show = |value| proposal.request.units.show(value, Dimension::LENGTH);
    let rollers = match c.rollers {
        1 => "one roller".to_owned(),
        n => format!("{n} rollers, {} apart,", show(c.spacing)),
    };
    let [wide, long] = c.geometry.upper.plan.map(show);
    format!(
        "Recommended (<): {rollers} {} x {}, plates {wide} x {long} x {}\n{}",
        show(c.diameter),
        show(c.length),
        show(c.plate),
        wrapped(&proposal.why, 2)
    )
}
