//! What came of a row: its line of the table, in a file of its own.

use super::error::SweepError;
use super::place::SweepFolder;
use super::rows::{Sweep, SweepRow};
use crate::ground::file::write_json;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// Its name in the folder of the row.
const RECORD_FILE: &str = "row.json";

/// How a row ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum RowStatus {
    #[serde(rename = "done")]
    Done,
    #[serde(rename = "limits missed")]
    LimitsMissed,
    #[serde(rename = "not converged")]
    NotConverged,
    #[serde(rename = "bad input")]
    BadInput,
    #[serde(rename = "interrupted")]
    Interrupted,
    /// The run ended without a word: it was killed, or it is a defect of Brinell.
    #[serde(rename = "crashed")]
    Crashed,
}

/// A line of the table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RowRecord {
    /// Counted from 1.
    pub row: usize,
    pub folder: String,
    /// That of [`SweepRow::fingerprint`].
    pub fingerprint: String,
    pub parameters: Vec<(String, Value)>,
    pub status: RowStatus,
    /// Why it is not done.
    pub message: String,
    /// Of the run that ended last.
    pub seconds: f64,
    /// Figures of the answer, where there is one.
    pub figures: Vec<(String, Value)>,
}

impl RowStatus {
    pub const ALL: [Self; 6] = [
        Self::Done,
        Self::LimitsMissed,
        Self::NotConverged,
        Self::BadInput,
        Self::Interrupted,
        Self::Crashed,
    ];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::LimitsMissed => "limits missed",
            Self::NotConverged => "not converged",
            Self::BadInput => "bad input",
            Self::Interrupted => "interrupted",
            Self::Crashed => "crashed",
        }
    }

    /// Would the same row end in the same way again? What was refused is tried again: gmsh, memory
    /// or room may have been short.
    pub fn is_final(self) -> bool {
        matches!(self, Self::Done | Self::LimitsMissed | Self::NotConverged)
    }
}

impl RowRecord {
    /// A row without an answer.
    pub fn without(row: &SweepRow, status: RowStatus, message: impl Into<String>) -> Self {
        let value = |v: &toml::Value| serde_json::to_value(v).unwrap_or_default();
        let parameters = row.parameters.iter();
        Self {
            row: row.number,
            folder: format!("rows/{}", row.name),
            fingerprint: row.fingerprint.clone(),
            parameters: parameters.map(|(k, v)| (k.clone(), value(v))).collect(),
            status,
            message: message.into(),
            seconds: 0.0,
            figures: Vec::new(),
        }
    }

    /// What came of `row`; `None` where nothing has yet, or only of another row in its place.
    pub fn read(place: &SweepFolder, row: &SweepRow) -> Option<Self> {
        let bytes = std::fs::read(place.row(row).join(RECORD_FILE)).ok()?;
        let record: Self = serde_json::from_slice(&bytes).ok()?;
        (record.fingerprint == row.fingerprint).then_some(record)
    }

    /// Has a run of `row` come to an end that need not be tried again?
    pub fn read_final(place: &SweepFolder, row: &SweepRow) -> Option<Self> {
        Self::read(place, row).filter(|record| record.status.is_final())
    }

    /// What came of the rows of `sweep` that have ended for good, by their numbers.
    ///
    /// # Errors
    /// [`SweepError::There`] where there are some, and the sweep is not to `resume`.
    pub fn all_final(
        sweep: &Sweep,
        place: &SweepFolder,
        resume: bool,
    ) -> Result<BTreeMap<usize, Self>, SweepError> {
        let rows = sweep.rows.iter();
        let ended = rows.filter_map(|row| Some((row.number, Self::read_final(place, row)?)));
        let ended: BTreeMap<usize, Self> = ended.collect();
        if !resume && !ended.is_empty() {
            return Err(SweepError::There {
                path: place.0.clone(),
                rows: ended.len(),
            });
        }
        Ok(ended)
    }

    /// Writes it into the folder of its row, which is made where there is none.
    ///
    /// # Errors
    /// [`SweepError`] names the path.
    pub fn write(&self, place: &SweepFolder, row: &SweepRow) -> Result<(), SweepError> {
        let folder = place.row(row);
        std::fs::create_dir_all(&folder).map_err(|error| SweepError::folder(&folder, error))?;
        let path = folder.join(RECORD_FILE);
        Ok(write_json(&path, self)?)
    }

    /// A figure of the answer.
    pub fn figure(&self, figure: &str) -> Option<&Value> {
        let found = self.figures.iter().find(|(name, _)| name == figure);
        found.map(|(_, value)| value)
    }

    /// The number of a figure.
    pub fn number(&self, figure: &str) -> Option<f64> {
        self.figure(figure)?.as_f64()
    }
}

/// Removes what an earlier run of a row left, where there is something.
///
/// # Errors
/// Where it cannot be removed.
pub fn forget(folder: &Path) -> Result<(), SweepError> {
    crate::ground::file::remove(&folder.join(RECORD_FILE))
        .map_err(|error| SweepError::folder(folder, error))
}
