//! Descent against load, in the table.

use super::{DIGITS, number};
use crate::render::summary::Summary;
use crate::render::text::{Columns, significant};

/// Loads, descents and the secant slopes between them, where the load pauses on its way up.
pub(super) fn load_line(summary: &Summary) -> String {
    let points = &summary.answer.load_line;
    if !points.windows(2).any(|pair| pair[1].load > pair[0].load) {
        return String::new();
    }
    let units = &summary.units;
    let mut table = Columns::new(&[
        "step",
        &format!("load {}", units.force),
        &format!("descent {}", units.length),
        &format!("slope {}/{}", units.force, units.length),
    ]);
    let mut before = (0.0, Some(0.0));
    for point in points {
        let rise = point.load - before.0;
        let run = point.descent.zip(before.1).map(|(now, then)| now - then);
        table.row([
            point.step.clone(),
            significant(point.load, DIGITS),
            number(point.descent),
            number(run.filter(|run| *run != 0.0).map(|run| rise / run)),
        ]);
        before = (point.load, point.descent);
    }
    format!(
        "Load and descent, slope from the row above\n{}",
        table.render()
    )
}
