//! Forces, pressures and lines of the interfaces.

use crate::answer::certify::Quantity;
use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// The force of each interface, and its pressure.
pub fn contact(summary: &Summary) -> Vec<Table> {
    let (answer, units) = (&summary.answer, &summary.units);
    let mut forces = Table::new(format!("Force on the lower body, {}", units.force))
        .words("interface")
        .figures(["along load", "share", "x", "y", "z", "∫p dA"]);
    let mut pressures = Table::new("Contact")
        .words("interface")
        .figure("p max", &units.stress)
        .figure("at", &units.length)
        .wide()
        .figures(["Hertz p0"])
        .figure("area", units.area())
        .figure("half-width", &units.length)
        .figure("penetration", &units.length)
        .figures(["of descent"])
        .figure("slip", &units.length)
        .wide()
        .figures(["open/stick/slip"]);
    for (name, i) in &answer.interfaces.0 {
        let mut row = vec![
            name.into(),
            Cell::figure(i.normal_force),
            Cell::Share(Some(i.normal_force / answer.applied_load)),
        ];
        row.extend(i.force.map(|f| Cell::component(f, i.normal_force)));
        row.push(Cell::figure(i.pressure_integral));
        forces.row(row);
        let certified = |value, what| Cell::certified(value, answer.figure(what, name));
        let descent = answer.descent.filter(|d| *d != 0.0);
        let counts = &i.status_counts;
        pressures.row([
            name.into(),
            certified(Some(i.max_pressure), Quantity::PeakPressure),
            Cell::Place(i.max_pressure_at),
            Cell::figure(i.hertz_p0),
            certified(Some(i.area), Quantity::ContactArea),
            certified(i.half_width, Quantity::HalfWidth),
            Cell::rough(i.max_penetration),
            Cell::Share(descent.map(|d| i.max_penetration / d.abs())),
            Cell::rough(i.max_slip),
            format!("{}/{}/{}", counts.open, counts.stick, counts.slip).into(),
        ]);
    }
    vec![forces, pressures]
}

/// Each line of contact: its largest load, and how far it carries.
pub fn lines(summary: &Summary) -> Table {
    let units = &summary.units;
    let length = &units.length;
    let mut table = Table::new("")
        .words("line of contact")
        .figure("across at", length)
        .figures(["lines"])
        .figure("largest load", units.line_load())
        .figure("at", length)
        .figure("half-width there", length)
        .wide()
        .figure("evenly", units.line_load())
        .wide()
        .figure("in contact", length)
        .figures(["lifted off"]);
    for (name, interface) in &summary.answer.interfaces.0 {
        for line in &interface.lines {
            table.row([
                name.into(),
                Cell::rough(line.across),
                line.images.into(),
                Cell::figure(line.peak),
                Cell::rough(line.peak_at),
                Cell::rough(line.half_width),
                Cell::figure(line.mean),
                Cell::rough(line.length),
                Cell::rough(line.lifted_off),
            ]);
        }
    }
    table
}
