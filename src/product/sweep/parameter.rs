//! The parameters of rows that have been solved: their values as words and as numbers.

use super::record::RowRecord;
use crate::ground::units::{Dimension, Quantity, UnitSystem};
use serde_json::Value;

/// The value of a row in `column`, where it sets one.
pub fn value<'r>(record: &'r RowRecord, column: &str) -> Option<&'r Value> {
    let found = record.parameters.iter().find(|(key, _)| key == column);
    found.map(|(_, value)| value)
}

/// Is the column not the same in all rows?
pub fn varies(column: &str, records: &[&RowRecord]) -> bool {
    let mut values = records.iter().map(|record| value(record, column));
    let first = values.next();
    values.any(|value| Some(value) != first)
}

/// Key and value for people, such as `roller wall 0.5 in`.
pub fn said(record: &RowRecord, column: &str) -> String {
    let name = column.rsplit('.').next().unwrap_or(column);
    let value = match value(record, column) {
        None => "as in the case".to_owned(),
        Some(Value::String(text)) => text.clone(),
        Some(other) => other.to_string(),
    };
    format!("{} {value}", name.replace('_', " "))
}

/// The column as numbers in the units of the rows, with that unit; `None` where a value is no number,
/// or they measure different things.
pub fn numbers(column: &str, records: &[&RowRecord]) -> Option<(Vec<f64>, String)> {
    let system = units(records.first()?)?;
    let values: Vec<&Value> = records
        .iter()
        .map(|r| value(r, column))
        .collect::<Option<_>>()?;
    let measured = |v: &&Value| Some(Quantity::parse(v.as_str()?).ok()?.dimension());
    let dimension = values.iter().find_map(measured).unwrap_or(Dimension::RATIO);
    let number = |value: &&Value| match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => {
            let number = Quantity::parse(text).ok()?.value_in(system, dimension);
            Some(system.shown(number.ok()?, dimension))
        }
        _ => None,
    };
    let numbers = values.iter().map(number).collect::<Option<_>>()?;
    Some((numbers, system.unit(dimension)))
}

/// The units of a row's answer.
pub fn units(record: &RowRecord) -> Option<UnitSystem> {
    UnitSystem::from_name(record.figure("units")?.as_str()?)
}
