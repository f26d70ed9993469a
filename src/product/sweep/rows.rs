//! The rows of a sweep: one case each.

use super::error::SweepError;
use super::file::{self, SweepFile};
use super::settings::KeyValues;
use crate::case::named_files::NamedFiles;
use crate::case::{self, Case, CaseError, variant};
use crate::ground::hash::Fnv;
use std::path::{Path, PathBuf};
use toml::Value;

/// A sweep, its rows made out of the case.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    pub title: String,
    /// The sweep file and the case that is varied.
    pub file: PathBuf,
    pub case: PathBuf,
    /// The keys that are varied, in order.
    pub columns: Vec<String>,
    pub rows: Vec<SweepRow>,
    pub(super) base: String,
    pub(super) fixed: KeyValues,
}

/// One run of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRow {
    /// Counted from 1.
    pub number: usize,
    pub parameters: KeyValues,
    /// The name of its folder.
    pub name: String,
    /// The case file of the row.
    pub text: String,
    /// Of that text and of the files that it names: a row with another fingerprint is another
    /// row.
    pub fingerprint: String,
}

/// Reads the sweep file at `path`, and makes its rows.
///
/// # Errors
/// [`SweepError`] where the file, its table of rows or the case cannot be read.
pub fn read(path: &Path) -> Result<Sweep, SweepError> {
    let plan = file::read(path)?;
    let base = crate::ground::input::text(&plan.case).map_err(|error| SweepError::Read {
        path: plan.case.clone(),
        error,
    })?;
    Ok(Sweep::of(plan, path, base))
}

impl Sweep {
    /// The rows that `plan`, read from `file`, makes of the case `base`.
    pub fn of(plan: SweepFile, file: &Path, base: String) -> Self {
        let varying = varying(&plan.columns, &plan.rows);
        let mut files = NamedFiles::new(&plan.case);
        let row = |(at, parameters): (usize, &KeyValues)| {
            let text = files.absolute(text(&base, &[&plan.fixed, parameters]));
            let content = files.content(&text);
            SweepRow {
                number: at + 1,
                name: name(at + 1, parameters, &varying),
                fingerprint: Fnv::hex(&format!("{text}{content}")),
                parameters: parameters.clone(),
                text,
            }
        };
        Self {
            rows: plan.rows.iter().enumerate().map(row).collect(),
            title: plan.title,
            file: file.to_owned(),
            case: plan.case,
            columns: plan.columns,
            fixed: plan.fixed,
            base,
        }
    }

    /// The case of a row, its meshes sought where those of the case that is varied are.
    ///
    /// # Errors
    /// Where the case makes no sense.
    pub fn case_of(&self, row: &SweepRow) -> Result<Case, CaseError> {
        case::parse(&self.case.to_string_lossy(), &row.text)
    }

    /// Row `number`, counted from 1.
    ///
    /// # Errors
    /// [`SweepError::NoSuchRow`].
    pub fn row(&self, number: usize) -> Result<&SweepRow, SweepError> {
        let row = number.checked_sub(1).and_then(|at| self.rows.get(at));
        row.ok_or(SweepError::NoSuchRow {
            row: number,
            rows: self.rows.len(),
        })
    }
}

impl SweepRow {
    /// Its parameters in words.
    pub fn said(&self) -> String {
        let words = self
            .parameters
            .iter()
            .map(|(key, value)| format!("{key} = {value}"));
        words.collect::<Vec<_>>().join(", ")
    }
}

/// A value without quotation marks.
fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// The case `base` with these settings.
pub fn text(base: &str, settings: &[&KeyValues]) -> String {
    let set = settings.iter().copied().flatten().cloned().collect();
    variant::changed(base, &set)
}

/// The columns whose value is not the same in all rows.
fn varying(columns: &[String], rows: &[KeyValues]) -> Vec<String> {
    let value = |row: &KeyValues, column: &str| {
        let found = row.iter().find(|(key, _)| key == column);
        found.map(|(_, value)| value.clone())
    };
    let varies = |column: &&String| {
        let mut values = rows.iter().map(|row| value(row, column));
        let first = values.next();
        values.any(|v| Some(v) != first)
    };
    columns.iter().filter(varies).cloned().collect()
}

/// The name of a row's folder: its number and what makes it differ, as far as file systems like it.
fn name(number: usize, parameters: &KeyValues, varying: &[String]) -> String {
    const LONGEST_NAME: usize = 60;
    let values = parameters.iter().filter(|(key, _)| varying.contains(key));
    let word = |(_, value): &(String, Value)| -> String {
        let fine = |c: &char| c.is_ascii_alphanumeric() || "._+".contains(*c);
        plain(value).chars().filter(fine).collect()
    };
    let words = values.map(word).filter(|word| !word.is_empty());
    let parts: Vec<String> = std::iter::once(format!("{number:04}"))
        .chain(words)
        .collect();
    parts.join("-").chars().take(LONGEST_NAME).collect()
}
