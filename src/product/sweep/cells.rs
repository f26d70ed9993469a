//! Rows from a CSV file: the first line names the keys, the others have their values.

use super::error::SweepError;
use super::settings::KeyValues;
use std::path::Path;
use toml::Value;

/// Reads the rows of the CSV file at `path`. An empty cell leaves the case as it is.
///
/// # Errors
/// [`SweepError`] where the file cannot be read, or a row is longer or shorter than the first line.
pub fn read(path: &Path) -> Result<Vec<KeyValues>, SweepError> {
    let text =
        crate::ground::input::bounded(path, crate::ground::input::TEXT).map_err(|error| {
            SweepError::Read {
                path: path.to_owned(),
                error,
            }
        })?;
    parse(&text).map_err(|message| SweepError::Csv {
        path: path.to_owned(),
        message,
    })
}

fn parse(text: &[u8]) -> Result<Vec<KeyValues>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text);
    let words = |error: csv::Error| error.to_string();
    let heads = reader.headers().map_err(words)?.clone();
    if let Some(at) = heads.iter().position(str::is_empty) {
        return Err(format!("column {} of the first line has no name", at + 1));
    }
    let twice = |(at, head): &(usize, &str)| heads.iter().take(*at).any(|h| h == *head);
    if let Some((_, head)) = heads.iter().enumerate().find(twice) {
        return Err(format!("the column `{head}` is there twice"));
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(words)?;
        let cells = heads.iter().zip(record.iter());
        let given = cells.filter(|(_, cell)| !cell.is_empty());
        rows.push(
            given
                .map(|(head, cell)| (head.to_owned(), value(cell)))
                .collect(),
        );
    }
    Ok(rows)
}

/// A cell as TOML has it, where it is a number, true or false, a list or a table; else as a string,
/// such as `65 kip`.
fn value(cell: &str) -> Value {
    let parsed = format!("cell = {cell}").parse::<toml::Table>();
    let value = parsed
        .ok()
        .filter(|t| t.len() == 1)
        .and_then(|mut t| t.remove("cell"));
    match value {
        Some(Value::Datetime(_)) | None => Value::String(cell.to_owned()),
        Some(value) => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_numbers_words_or_nothing() {
        let text =
            "bearing.load, bearing.friction ,mesh.preset\n# light\n65 kip,0.2,h025\n70 kip,,\n";
        let rows = parse(text.as_bytes()).unwrap();
        let first = [
            ("bearing.load", Value::String("65 kip".into())),
            ("bearing.friction", Value::Float(0.2)),
            ("mesh.preset", Value::String("h025".into())),
        ];
        assert_eq!(rows[0], first.map(|(k, v)| (k.to_owned(), v)));
        assert_eq!(rows[1].len(), 1);
        assert_eq!(value("true"), Value::Boolean(true));
        assert_eq!(value("{ x = 1 }")["x"].as_integer(), Some(1));
        assert_eq!(value("2026-01-01").as_str(), Some("2026-01-01"));
    }

    #[test]
    fn crooked_tables_are_refused() {
        for (text, why) in [
            ("a,b\n1\n", "record 1"),
            ("a,a\n1,2\n", "`a` is there twice"),
            ("a,\n1,2\n", "column 2"),
        ] {
            let error = parse(text.as_bytes()).unwrap_err();
            assert!(error.contains(why), "{error}");
        }
    }
}
