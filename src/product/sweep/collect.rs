//! One table from rows that ran by themselves, such as the tasks of a job array.

use super::error::SweepError;
use super::place::SweepFolder;
use super::record::RowRecord;
use super::rows::Sweep;
use super::table;

/// Gathers what came of the rows of `sweep` in `place` into the table; comes back with that, and with
/// the numbers of the rows that have not ended.
///
/// # Errors
/// [`SweepError::Output`] where the table cannot be written.
pub fn collect(
    sweep: &Sweep,
    place: &SweepFolder,
) -> Result<(Vec<RowRecord>, Vec<usize>), SweepError> {
    let mut records = Vec::new();
    let mut missing = Vec::new();
    for row in &sweep.rows {
        match RowRecord::read(place, row) {
            Some(record) => records.push(record),
            None => missing.push(row.number),
        }
    }
    table::write(place, &sweep.columns, records.iter())?;
    Ok((records, missing))
}
