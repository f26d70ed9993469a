//! What ties carry.

use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// The force of each tie, and the stresses across it; none where nothing is tied.
pub fn ties(summary: &Summary) -> Vec<Table> {
    let (answer, units) = (&summary.answer, &summary.units);
    if answer.ties.is_empty() {
        return Vec::new();
    }
    let force = format!("Ties: force on the second surface, {}", units.force);
    let mut forces = Table::new(force)
        .words("tie")
        .figures(["x", "y", "z", "∫p dA"]);
    let mut stresses = Table::new("Stress across ties")
        .words("tie")
        .figure("p max", &units.stress)
        .figures(["tension max", "shear max"])
        .figure("largest at", &units.length)
        .wide()
        .figure("area", units.area())
        .figures(["covered"])
        .figure("distance", &units.length);
    for (name, tie) in &answer.ties.0 {
        let size = tie.force.iter().fold(0.0f64, |sum, f| sum.hypot(*f));
        let mut row = vec![name.into()];
        row.extend(tie.force.map(|f| Cell::component(f, size)));
        row.push(Cell::component(tie.pressure_integral, size));
        forces.row(row);
        stresses.row([
            name.into(),
            Cell::figure(tie.max_pressure),
            Cell::figure(tie.max_tension),
            Cell::figure(tie.max_shear),
            Cell::Place(tie.at),
            Cell::figure(tie.area),
            Cell::Share(Some(tie.covered)),
            Cell::rough(tie.distance),
        ]);
    }
    vec![forces, stresses]
}
