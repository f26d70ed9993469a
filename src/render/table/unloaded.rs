//! What is left after unloading, in the table.

use super::{DIGITS, number};
use crate::render::summary::Summary;
use crate::render::text::{Columns, place, significant};

pub(super) fn unloaded(summary: &Summary) -> String {
    let Some(unloaded) = &summary.answer.unloaded else {
        return String::new();
    };
    let units = &summary.units;
    let mut dents = Columns::new(&["surface", "of", &format!("dent {}", units.length), "at"]);
    for (name, dent) in &unloaded.dents.0 {
        dents.row([
            name.clone(),
            dent.body.clone(),
            significant(dent.depth, 3),
            place(dent.at),
        ]);
    }
    let pressed = match unloaded.elastic_removed {
        true => "",
        false => "; dents with the elastic pressing of that load in them",
    };
    format!(
        "Unloaded to {} {}, descent left {} {}{pressed}\n{}",
        significant(unloaded.applied_load, DIGITS),
        units.force,
        number(unloaded.descent),
        units.length,
        dents.render()
    )
}
