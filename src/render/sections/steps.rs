//! All steps side by side.

use crate::answer::StepFigures;
use crate::ground::geometry::norm;
use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// The ends of the steps; no rows for a single one.
pub fn steps(summary: &Summary) -> Table {
    let units = &summary.units;
    let mut table = Table::new("")
        .words("Steps, at their ends")
        .figure("load", &units.force)
        .figures(["x", "y", "z"])
        .figure("descent", &units.length)
        .figure("Mises", &units.stress)
        .figure("p max", &units.stress)
        .figures(["plastic strain", "stick/slip"]);
    if summary.answer.steps.len() < 2 {
        return table;
    }
    for step in &summary.answer.steps {
        let mut row = vec![(&step.name).into(), Cell::figure(step.load)];
        let whole = norm(step.force);
        row.extend(step.force.map(|f| Cell::component(f, whole)));
        let [stick, slip] = step.stick_and_slip();
        row.extend([
            Cell::figure(step.descent),
            Cell::figure(step.mises_max.nodal),
            Cell::figure(step.max_pressure()),
            Cell::rough(step.peeq_max),
            format!("{stick}/{slip}").into(),
        ]);
        table.row(row);
    }
    table.note(format!("All other figures are of {}.", moment(summary)));
    table
}

/// The moment that the figures are of, in words.
fn moment(summary: &Summary) -> String {
    let name = |step: &StepFigures| format!("the end of step \u{201c}{}\u{201d}", step.name);
    match summary.answer.steps.iter().find(|step| step.reported) {
        Some(step) if summary.answer.unloaded.is_some() => {
            format!("{}, the last before unloading", name(step))
        }
        Some(step) => name(step),
        None => format!(
            "step \u{201c}{}\u{201d}, as far as it is done",
            summary.answer.step
        ),
    }
}
