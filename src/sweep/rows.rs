//! The rows of a sweep: one case each.

use super::error::{RowError, SweepError};
use super::file::{self, Settings};
use crate::case::{self, Case, CaseError, ErrorKind, variant};
use crate::hash::Fnv;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// A sweep, its rows made out of the case.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    pub title: String,
    /// The sweep file and the case that is varied.
    pub file: PathBuf,
    pub case: PathBuf,
    /// The keys that are varied, in order.
    pub columns: Vec<String>,
    pub rows: Vec<Row>,
    base: String,
    fixed: Settings,
}

/// One run of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Counted from 1.
    pub number: usize,
    pub parameters: Settings,
    /// The name of its folder.
    pub name: String,
    /// The case file of the row.
    pub text: String,
    /// Of that text and of the mesh file that it names: a row with another fingerprint is another
    /// row.
    pub fingerprint: String,
}

/// Reads the sweep file at `path`, and makes its rows.
///
/// # Errors
/// [`SweepError`] where the file, its table of rows or the case cannot be read.
pub fn read(path: &Path) -> Result<Sweep, SweepError> {
    let plan = file::read(path)?;
    let base = std::fs::read_to_string(&plan.case).map_err(|error| SweepError::Read {
        path: plan.case.clone(),
        error,
    })?;
    let mut meshes = Meshes::new(&plan.case);
    let varying = varying(&plan.columns, &plan.rows);
    let row = |(at, parameters): (usize, &Settings)| {
        let text = meshes.absolute(text(&base, &[&plan.fixed, parameters]));
        let mesh = meshes.content(&text);
        Row {
            number: at + 1,
            name: name(at + 1, parameters, &varying),
            fingerprint: format!("{:016x}", Fnv::of(format!("{text}{mesh:x}").as_bytes())),
            parameters: parameters.clone(),
            text,
        }
    };
    Ok(Sweep {
        rows: plan.rows.iter().enumerate().map(row).collect(),
        title: plan.title,
        file: path.to_owned(),
        case: plan.case,
        columns: plan.columns,
        fixed: plan.fixed,
        base,
    })
}

impl Sweep {
    /// The case of a row, its meshes sought where those of the case that is varied are.
    ///
    /// # Errors
    /// Where the case makes no sense.
    pub fn case_of(&self, row: &Row) -> Result<Case, CaseError> {
        case::parse(&self.case.to_string_lossy(), &row.text)
    }

    /// What is wrong with a row: a key has no place in the case, or the case makes no sense.
    fn wrong(&self, row: &Row) -> Option<CaseError> {
        let set = self.fixed.iter().chain(&row.parameters);
        for (key, _) in set {
            if !variant::has_place(&self.base, key) {
                let message = format!("the case {} has no place for `{key}`", self.case.display());
                return Some(CaseError::new(ErrorKind::UnknownKey, message));
            }
        }
        // The lines that are marked are those of the row, not of the case.
        let name = format!("{} with row {}", self.case.display(), row.number);
        case::parse(&name, &row.text).err()
    }

    /// Reads the case of every row; nothing is solved.
    ///
    /// # Errors
    /// [`SweepError::Rows`] with the first few rows that are wrong.
    pub fn validate(&self) -> Result<(), SweepError> {
        const TOLD: usize = 5;
        let rows = self.rows.iter();
        let wrong = rows.filter_map(|row| Some((row, self.wrong(row)?)));
        let wrong: Vec<(&Row, CaseError)> = wrong.collect();
        if wrong.is_empty() {
            return Ok(());
        }
        let all = self.rows.len();
        let count = wrong.len();
        let error = |(row, error): (&Row, CaseError)| RowError {
            row: row.number,
            place: self.place(row, &error),
            error,
        };
        Err(SweepError::Rows {
            wrong: count,
            all,
            errors: wrong.into_iter().take(TOLD).map(error).collect(),
        })
    }

    /// Row `number`, counted from 1.
    ///
    /// # Errors
    /// [`SweepError::NoSuchRow`].
    pub fn row(&self, number: usize) -> Result<&Row, SweepError> {
        let row = number.checked_sub(1).and_then(|at| self.rows.get(at));
        row.ok_or(SweepError::NoSuchRow {
            row: number,
            rows: self.rows.len(),
        })
    }

    /// The column and value that are to blame for `error`: the one that it names, or the one that
    /// is wrong by itself; all of them where it takes several.
    fn place(&self, row: &Row, error: &CaseError) -> String {
        let message = error.to_string();
        let alone = |parameter: &&(String, Value)| {
            let one = vec![(*parameter).clone()];
            let is_wrong =
                |settings: &[&Settings]| case::parse("", &text(&self.base, settings)).is_err();
            is_wrong(&[&self.fixed, &one]) && !is_wrong(&[&self.fixed])
        };
        let parameters = || row.parameters.iter();
        let named = parameters().find(|(key, _)| message.contains(key.as_str()));
        match named.or_else(|| parameters().find(alone)) {
            Some((key, value)) => format!("column `{key}`, value {value}"),
            None => row.said(),
        }
    }
}

impl Row {
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

fn text(base: &str, settings: &[&Settings]) -> String {
    let set = settings.iter().copied().flatten().cloned().collect();
    variant::changed(base, &set)
}

/// The columns whose value is not the same in all rows.
fn varying(columns: &[String], rows: &[Settings]) -> Vec<String> {
    let value = |row: &Settings, column: &str| {
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
fn name(number: usize, parameters: &Settings, varying: &[String]) -> String {
    const LONGEST: usize = 60;
    let values = parameters.iter().filter(|(key, _)| varying.contains(key));
    let word = |(_, value): &(String, Value)| -> String {
        let fine = |c: &char| c.is_ascii_alphanumeric() || "._+".contains(*c);
        plain(value).chars().filter(fine).collect()
    };
    let words = values.map(word).filter(|word| !word.is_empty());
    let parts: Vec<String> = std::iter::once(format!("{number:04}"))
        .chain(words)
        .collect();
    parts.join("-").chars().take(LONGEST).collect()
}

/// Mesh files that rows name.
struct Meshes {
    /// Folder of the case that is varied.
    folder: PathBuf,
    /// Hashes of their content.
    known: BTreeMap<PathBuf, u64>,
}

impl Meshes {
    fn new(case: &Path) -> Self {
        let folder = case.parent().unwrap_or(Path::new(""));
        Self {
            folder: std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned()),
            known: BTreeMap::new(),
        }
    }

    /// `text` with the absolute path of its mesh file: the case of a row stands in another folder.
    fn absolute(&self, text: String) -> String {
        let Some(file) = mesh_file(&text).filter(|file| file.is_relative()) else {
            return text;
        };
        let path = self.folder.join(file).to_string_lossy().into_owned();
        let set = BTreeMap::from([("mesh.file".to_owned(), Value::String(path))]);
        variant::changed(&text, &set)
    }

    /// A hash of the mesh file's content; zero where there is none.
    fn content(&mut self, text: &str) -> u64 {
        let Some(file) = mesh_file(text) else {
            return 0;
        };
        let hash = |path: &PathBuf| std::fs::read(path).map_or(0, |bytes| Fnv::of(&bytes));
        *self.known.entry(file).or_insert_with_key(hash)
    }
}

fn mesh_file(text: &str) -> Option<PathBuf> {
    let case = text.parse::<Table>().ok()?;
    let file = case.get("mesh")?.get("file")?.as_str()?;
    Some(PathBuf::from(file))
}
