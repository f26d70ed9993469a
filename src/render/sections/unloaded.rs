//! What is left after unloading.

use crate::render::figures::DIGITS;
use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

/// The dents that stay; none where nothing is unloaded.
pub fn unloaded(summary: &Summary) -> Option<Table> {
    let unloaded = summary.answer.unloaded.as_ref()?;
    let units = &summary.units;
    let pressed = if unloaded.elastic_removed {
        ""
    } else {
        "; dents with the elastic pressing of that load in them"
    };
    let descent = unloaded
        .descent
        .map_or("-".to_string(), |d| significant(d, DIGITS));
    let title = format!(
        "Unloaded to {} {}, descent left {descent} {}{pressed}",
        significant(unloaded.applied_load, DIGITS),
        units.force,
        units.length,
    );
    let mut table = Table::new(title)
        .words("surface")
        .words("of")
        .figure("dent", &units.length)
        .figures(["at"]);
    for (name, dent) in &unloaded.dents.0 {
        table.row([
            name.into(),
            (&dent.body).into(),
            Cell::rough(dent.depth),
            Cell::Place(Some(dent.at)),
        ]);
    }
    Some(table)
}
