//! What a checker can recompute by hand.

use crate::render::figures::MESH_DIGITS;
use crate::render::summary::Summary;
use crate::render::table::{Cell, Number, Table};

/// Each figure by its formula, what the run found, and why they need not agree.
pub fn hand_checks(summary: &Summary) -> Table {
    let mut table = Table::new("Recomputed by hand")
        .words("what")
        .words("where")
        .words("formula")
        .figures(["by hand", "found", "± error", "off"])
        .words("may differ, as")
        .about(
            "Formulas for a pocket calculator, with their numbers. The line load q is the largest that the run found: \
             Hertz's formulas are asked of it, and equilibrium of the whole.",
        );
    for check in &summary.hand_checks {
        let off = check.found.map(|found| found / check.by_hand - 1.0);
        table.row([
            (&check.what).into(),
            (&check.place).into(),
            (&check.formula).into(),
            Cell::figure(check.by_hand),
            Cell::figure(check.found),
            Cell::Figure(Number::new(check.error, MESH_DIGITS)),
            Cell::Off(off),
            check.differs.into(),
        ]);
    }
    table
}
