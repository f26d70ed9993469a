//! The table of a sweep, `table.csv` and `table.jsonl`: a line for each row that has ended.

use super::error::SweepError;
use super::parameter;
use super::place::SweepFolder;
use super::record::RowRecord;
use crate::answer::Named;
use crate::ground::file::write_atomically;
use crate::render::text::shown;
use serde_json::Value;
use std::collections::HashSet;
use std::io;

pub const CSV: &str = "table.csv";
pub const JSON_LINES: &str = "table.jsonl";

/// Writes both files into the folder of the sweep, each whole or not at all; `records` in their order.
///
/// # Errors
/// [`SweepError::Output`] names the path.
pub fn write<'r>(
    place: &SweepFolder,
    columns: &[String],
    records: impl Iterator<Item = &'r RowRecord>,
) -> Result<(), SweepError> {
    let lines: Vec<TableLine> = records
        .map(|record| TableLine::new(record, columns))
        .collect();
    let heads = heads(&lines);
    write_atomically(&place.0.join(CSV), |out| as_csv(&heads, &lines, out))?;
    write_atomically(&place.0.join(JSON_LINES), |out| {
        as_json(&heads, &lines, out)
    })?;
    Ok(())
}

/// Cells by column.
struct TableLine(Vec<(String, Value)>);

impl TableLine {
    fn new(record: &RowRecord, columns: &[String]) -> Self {
        let mut cells = vec![("row".to_owned(), record.row.into())];
        for column in columns {
            let value = parameter::value(record, column).cloned();
            cells.push((column.clone(), value.unwrap_or_default()));
        }
        cells.push(("status".to_owned(), record.status.name().into()));
        cells.push(("message".to_owned(), record.message.clone().into()));
        cells.push(("folder".to_owned(), record.folder.clone().into()));
        cells.push(("seconds".to_owned(), record.seconds.into()));
        cells.extend(record.figures.iter().cloned());
        Self(cells)
    }

    fn cell(&self, head: &str) -> &Value {
        let found = self.0.iter().find(|(name, _)| name == head);
        found.map_or(&Value::Null, |(_, value)| value)
    }
}

/// All columns, in the order in which lines have them.
fn heads(lines: &[TableLine]) -> Vec<&str> {
    let mut seen = HashSet::new();
    let names = lines
        .iter()
        .flat_map(|line| &line.0)
        .map(|(name, _)| name.as_str());
    names.filter(|name| seen.insert(*name)).collect()
}

fn as_csv(heads: &[&str], lines: &[TableLine], out: &mut dyn io::Write) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(heads.iter().map(|head| shown(head).into_owned()))?;
    for line in lines {
        let cell = |head: &&str| match line.cell(head) {
            Value::Null => String::new(),
            Value::String(text) => shown(text).into_owned(),
            other => other.to_string(),
        };
        table.write_record(heads.iter().map(cell))?;
    }
    table.flush()
}

fn as_json(heads: &[&str], lines: &[TableLine], out: &mut dyn io::Write) -> io::Result<()> {
    for line in lines {
        let cells = heads.iter().map(|h| ((*h).to_owned(), line.cell(h)));
        serde_json::to_writer(&mut *out, &Named(cells.collect()))?;
        writeln!(out)?;
    }
    Ok(())
}
