//! Descent against load.

use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// Loads, descents and the secant slopes between them, where the load pauses on its way up.
pub fn load_line(summary: &Summary) -> Table {
    let points = &summary.answer.load_line;
    let units = &summary.units;
    let mut table = Table::new("Load and descent, slope from the row above")
        .words("step")
        .figure("load", &units.force)
        .figure("descent", &units.length)
        .figure("slope", format!("{}/{}", units.force, units.length));
    if !points.windows(2).any(|pair| pair[1].load > pair[0].load) {
        return table;
    }
    let mut before = (0.0, Some(0.0));
    for point in points {
        let rise = point.load - before.0;
        let run = point.descent.zip(before.1).map(|(now, then)| now - then);
        table.row([
            (&point.step).into(),
            Cell::figure(point.load),
            Cell::figure(point.descent),
            Cell::figure(run.filter(|run| *run != 0.0).map(|run| rise / run)),
        ]);
        before = (point.load, point.descent);
    }
    table
}
