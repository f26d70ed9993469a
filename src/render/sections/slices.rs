//! The load per length along the interfaces, in slices.

use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};
use crate::render::text::significant;

/// Interfaces with the same slices share a table.
pub fn slices(summary: &Summary) -> Vec<Table> {
    let unit = summary.units.line_load();
    let mut tables: Vec<(&[f64], Table)> = Vec::new();
    for (name, interface) in &summary.answer.interfaces.0 {
        let Some(q) = &interface.q else { continue };
        let known = tables.iter().position(|(edges, _)| *edges == q.edges);
        let index = known.unwrap_or_else(|| {
            // Two decimals where they tell ends apart, as in inches and millimetres.
            let narrowest = q.edges.windows(2).map(|pair| (pair[1] - pair[0]).abs());
            let fine = narrowest.fold(f64::INFINITY, f64::min) < 0.05;
            let mut ends = q.edges.iter().map(|end| match fine {
                true => significant(*end, 3),
                false => format!("{end:.2}"),
            });
            let start = ends.next().unwrap_or_default();
            let table = Table::new(format!("Line load from {start} on, {unit}"));
            tables.push((&q.edges, table.words("slice ends").figures(ends)));
            tables.len() - 1
        });
        let label = Cell::Text(format!("{name}, along {}", q.axis));
        let values = q.values.iter().map(|value| Cell::rough(*value));
        tables[index].1.row(std::iter::once(label).chain(values));
    }
    tables.into_iter().map(|(_, table)| table).collect()
}
