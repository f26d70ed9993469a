//! Figures of this run beside printed ones and Hertz's.

use crate::render::figures::DIGITS;
use crate::render::summary::{Reported, Summary};
use crate::render::table::{Cell, Number, Table};
use crate::render::text::significant;

/// What the case file cites, beside what was found.
pub fn compared(summary: &Summary) -> Table {
    let mut table = Table::new("Compared")
        .words("")
        .words("where")
        .figures(["this run", "report", "report-like mesh", "Hertz"])
        .about(
            "Report: what the case file cites. Hertz: the closed form for a line load spread evenly. Comparisons \
             decide nothing.",
        );
    for row in &summary.comparison {
        let report = match row.report {
            Some(Reported::Value(value)) => Cell::figure(value),
            Some(Reported::Range(ends)) => {
                let [low, high] = ends.map(|end| significant(end, DIGITS));
                format!("{low} to {high}").into()
            }
            None => Cell::figure(None),
        };
        table.row([
            (&row.what).into(),
            (&row.place).into(),
            Cell::Estimate(Number {
                error: row.error,
                resolved: row.resolved != Some(false) || row.value.is_none(),
                ..Number::new(row.value, DIGITS)
            }),
            report,
            Cell::figure(row.report_like),
            Cell::figure(row.hertz),
        ]);
    }
    table
}
