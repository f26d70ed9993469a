//! Are all rows cases? Asked before anything is run.

use super::error::{RowError, SweepError};
use super::rows::{Sweep, SweepRow, text};
use super::settings::KeyValues;
use crate::case::{self, CaseError, ErrorKind, variant};
use toml::Value;

impl Sweep {
    /// Reads the case of every row; nothing is solved.
    ///
    /// # Errors
    /// [`SweepError::Rows`] with the first few rows that are wrong.
    pub fn validate(&self) -> Result<(), SweepError> {
        // The same mistake stands in many rows: the first few show it.
        const ERRORS_TOLD: usize = 5;
        let rows = self.rows.iter();
        let wrong = rows.filter_map(|row| Some((row, self.wrong(row)?)));
        let wrong: Vec<(&SweepRow, CaseError)> = wrong.collect();
        if wrong.is_empty() {
            return Ok(());
        }
        let all = self.rows.len();
        let count = wrong.len();
        let error = |(row, error): (&SweepRow, CaseError)| RowError {
            row: row.number,
            place: self.place(row, &error),
            error,
        };
        Err(SweepError::Rows {
            wrong: count,
            all,
            errors: wrong.into_iter().take(ERRORS_TOLD).map(error).collect(),
        })
    }

    /// What is wrong with a row: a key has no place in the case, or the case makes no sense.
    fn wrong(&self, row: &SweepRow) -> Option<CaseError> {
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

    /// The column and value that are to blame for `error`: the one that it names, or the one that
    /// is wrong by itself; all of them where it takes several.
    fn place(&self, row: &SweepRow, error: &CaseError) -> String {
        let message = error.to_string();
        let alone = |parameter: &&(String, Value)| {
            let one = vec![(*parameter).clone()];
            let is_wrong =
                |settings: &[&KeyValues]| case::parse("", &text(&self.base, settings)).is_err();
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
