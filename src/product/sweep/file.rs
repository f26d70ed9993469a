//! The sweep file: the case that is varied, and the table of what is varied.
//!
//! ```toml
//! case = "section-2.6.2/initial-centre.toml"   # beside this file
//!
//! [set]                                        # in every row
//! mesh.preset = "report-like"
//!
//! [grid]                                       # every combination; or [[row]], or csv = "rows.csv"
//! bearing.load = ["45 kip", "65 kip"]
//! bearing.roller_wall = ["0.5 in", "0.75 in"]
//! ```

use super::cells;
use super::error::SweepError;
use super::settings::KeyValues;
use serde::Deserialize;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue, ValueDeserializer};
use toml::{Spanned, Value};

/// A sweep as its file has it: nothing of the case is understood yet.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepFile {
    pub title: String,
    /// The case that is varied.
    pub case: PathBuf,
    /// What every row sets.
    pub fixed: KeyValues,
    /// The keys that are varied, in order.
    pub columns: Vec<String>,
    /// What each row sets beside that. A row may leave out columns: they stay as in the case.
    pub rows: Vec<KeyValues>,
}

/// A sweep with more rows than this is taken for a mistake in its file.
const MOST_ROWS: usize = 100_000;

/// So is one with more values than this in all rows of a grid.
const MOST_VALUES: usize = 1_000_000;

const KEYS: [&str; 6] = ["title", "case", "set", "grid", "row", "csv"];

/// Reads the sweep file at `path`.
///
/// # Errors
/// [`SweepError`] where it, or the CSV file that it names, cannot be read or understood.
pub fn read(path: &Path) -> Result<SweepFile, SweepError> {
    let text = crate::ground::input::text(path).map_err(|error| SweepError::Read {
        path: path.to_owned(),
        error,
    })?;
    parse(path, &text)
}

/// Reads `text` as the sweep file at `path`.
///
/// # Errors
/// [`SweepError`] where it, or the CSV file that it names, cannot be read or understood.
pub fn parse(path: &Path, text: &str) -> Result<SweepFile, SweepError> {
    SweepReader { path, text }.read()
}

struct SweepReader<'a> {
    path: &'a Path,
    text: &'a str,
}

/// A dotted key and its value, with their place.
type Leaf<'t> = (String, &'t Spanned<DeValue<'t>>);

impl SweepReader<'_> {
    fn read(&self) -> Result<SweepFile, SweepError> {
        let document = DeTable::parse(self.text).map_err(|error| {
            let message = format!("it is no TOML: {}", error.message().trim());
            self.error(error.span().unwrap_or(0..0), message)
        })?;
        let root = document.get_ref();
        for (key, _) in root.iter() {
            if !KEYS.contains(&key.get_ref().as_ref()) {
                let message = format!("`{}` is not a key of a sweep", key.get_ref());
                return Err(self.wrong(
                    key.span(),
                    message,
                    &format!("one of {}", KEYS.join(", ")),
                ));
            }
        }
        let beside = |name: &str| self.path.parent().unwrap_or(Path::new("")).join(name);
        let case = self.text(root, "case")?.ok_or_else(|| {
            let message = "the key `case` is missing: the file of the case that is varied";
            self.error(0..0, message)
        })?;
        let title = match self.text(root, "title")? {
            Some(title) => title,
            None => self
                .path
                .file_stem()
                .map_or_else(String::new, |s| s.to_string_lossy().into_owned()),
        };
        let fixed = match get(root, "set") {
            Some(set) => self.settings(set)?,
            None => Vec::new(),
        };
        let mut given = ["grid", "row", "csv"]
            .into_iter()
            .filter_map(|key| Some((key, get(root, key)?)));
        let (kind, value) = given.next().ok_or_else(|| {
            let message = "there are no rows: give [grid], [[row]] or csv = \"...\"";
            self.error(0..0, message)
        })?;
        if let Some((other, value)) = given.next() {
            let message =
                format!("`{other}` does not go with `{kind}`: rows come from one of them");
            return Err(self.error(value.span(), message));
        }
        let rows = match kind {
            "grid" => self.grid(value)?,
            "row" => self.list(value)?,
            _ => cells::read(&beside(&self.text(root, "csv")?.unwrap_or_default()))?,
        };
        if rows.is_empty() {
            return Err(self.error(value.span(), "there are no rows"));
        }
        let mut columns: Vec<String> = Vec::new();
        for (key, _) in rows.iter().flatten() {
            if !columns.contains(key) {
                columns.push(key.clone());
            }
        }
        if let Some(twice) = columns
            .iter()
            .find(|c| fixed.iter().any(|(key, _)| key == *c))
        {
            let message = format!("`{twice}` is both set for every row and varied");
            return Err(self.error(value.span(), message));
        }
        Ok(SweepFile {
            title,
            case: beside(&case),
            fixed,
            columns,
            rows,
        })
    }

    fn text(&self, root: &DeTable, key: &str) -> Result<Option<String>, SweepError> {
        let Some(value) = get(root, key) else {
            return Ok(None);
        };
        match value.get_ref().as_str() {
            Some(text) => Ok(Some(text.to_owned())),
            None => Err(self.error(value.span(), format!("`{key}` must be a string"))),
        }
    }

    fn settings(&self, table: &Spanned<DeValue>) -> Result<KeyValues, SweepError> {
        let leaves = self.leaves(table)?.into_iter();
        leaves.map(|(key, v)| Ok((key, self.value(v)?))).collect()
    }

    /// Every combination, the last key changing fastest.
    fn grid(&self, table: &Spanned<DeValue>) -> Result<Vec<KeyValues>, SweepError> {
        let mut rows: Vec<KeyValues> = vec![Vec::new()];
        for (columns, (key, values)) in (1..).zip(self.leaves(table)?) {
            let list = values.get_ref().as_array();
            let list = list.filter(|list| !list.is_empty()).ok_or_else(|| {
                let message = format!("`{key}` must be a list of values, such as [1, 2]");
                self.error(values.span(), message)
            })?;
            let count = rows.len().saturating_mul(list.len());
            let beyond = [
                (count > MOST_ROWS, MOST_ROWS, "rows"),
                (
                    count.saturating_mul(columns) > MOST_VALUES,
                    MOST_VALUES,
                    "values",
                ),
            ];
            if let Some((_, most, what)) = beyond.into_iter().find(|(is, ..)| *is) {
                let message = format!("the grid has more than {most} {what}");
                return Err(self.error(values.span(), message));
            }
            let list: Vec<Value> = list
                .iter()
                .map(|v| self.value(v))
                .collect::<Result<_, _>>()?;
            let longer = |row: &KeyValues| -> Vec<KeyValues> {
                let with =
                    |value: &Value| [row.clone(), vec![(key.clone(), value.clone())]].concat();
                list.iter().map(with).collect()
            };
            rows = rows.iter().flat_map(longer).collect();
        }
        rows.retain(|row| !row.is_empty());
        Ok(rows)
    }

    fn list(&self, rows: &Spanned<DeValue>) -> Result<Vec<KeyValues>, SweepError> {
        let tables = rows
            .get_ref()
            .as_array()
            .ok_or_else(|| self.error(rows.span(), "each row begins with a line [[row]]"))?;
        tables.iter().map(|row| self.settings(row)).collect()
    }

    /// The values below a table, in the order of the file.
    fn leaves<'t>(&self, table: &'t Spanned<DeValue<'t>>) -> Result<Vec<Leaf<'t>>, SweepError> {
        let Some(entries) = table.get_ref().as_table() else {
            let message = "a table of keys of the case is wanted";
            return Err(self.error(table.span(), message));
        };
        let mut leaves = Vec::new();
        collect("", entries, &mut leaves);
        leaves.sort_by_key(|(_, value)| value.span().start);
        Ok(leaves)
    }

    fn value(&self, value: &Spanned<DeValue>) -> Result<Value, SweepError> {
        Value::deserialize(ValueDeserializer::from(value.clone()))
            .map_err(|error| self.error(value.span(), error.message().to_owned()))
    }

    fn error(&self, span: Range<usize>, message: impl Into<String>) -> SweepError {
        SweepError::at((self.path, self.text), span, message, None)
    }

    fn wrong(&self, span: Range<usize>, message: String, help: &str) -> SweepError {
        SweepError::at((self.path, self.text), span, message, Some(help.to_owned()))
    }
}

fn get<'t>(table: &'t DeTable<'t>, key: &str) -> Option<&'t Spanned<DeValue<'t>>> {
    table
        .iter()
        .find(|(k, _)| k.get_ref().as_ref() == key)
        .map(|(_, value)| value)
}

fn collect<'t>(prefix: &str, table: &'t DeTable<'t>, leaves: &mut Vec<Leaf<'t>>) {
    for (key, value) in table.iter() {
        let key = format!("{prefix}{}", key.get_ref());
        match value.get_ref().as_table() {
            Some(inner) => collect(&format!("{key}."), inner, leaves),
            None => leaves.push((key, value)),
        }
    }
}
