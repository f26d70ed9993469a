//! The load per length along the interfaces, in slices.

use crate::render::summary::Summary;
use crate::render::table::{Cell, Table};

/// Interfaces with the same slices share a table.
pub fn slices(summary: &Summary) -> Vec<Table> {
    let unit = summary.units.line_load();
    let mut tables: Vec<(&[f64], Table)> = Vec::new();
    for (name, interface) in &summary.answer.interfaces.0 {
        let Some(q) = &interface.q else { continue };
        let known = tables.iter().position(|(edges, _)| *edges == q.edges);
        let index = known.unwrap_or_else(|| {
            let mut ends = q.edges.iter().map(|end| format!("{end:.2}"));
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
