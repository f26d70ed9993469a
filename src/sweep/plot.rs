//! Peak Mises stress and utilisation over each parameter that varies and is a number.

use super::error::SweepError;
use super::place::Place;
use super::record::Record;
use crate::output::plot::{Figure, Line, Panel, Scale, write};
use crate::units::{Dimension, Quantity, UnitSystem};
use serde_json::Value;
use std::path::PathBuf;

/// Lines of more groups than this cannot be told apart: then there are dots only.
const MOST: usize = 7;

/// The figures that are drawn: name in the table, title, and the dashed level.
const DRAWN: [(&str, &str, Option<f64>); 4] = [
    ("mises_nodal", "largest Mises, nodal", None),
    (
        "elastic_mises_nodal",
        "largest Mises, nodal, without yielding",
        None,
    ),
    (
        "utilisation",
        "p0 under the largest line load / 1.65 yield",
        Some(1.0),
    ),
    ("descent", "descent", None),
];

/// Draws what the rows came to over each parameter; comes back with the files.
///
/// # Errors
/// [`SweepError::Output`] names the path.
pub fn draw(
    place: &Place,
    columns: &[String],
    records: &[Record],
) -> Result<Vec<PathBuf>, SweepError> {
    let solved: Vec<&Record> = records.iter().filter(|r| !r.figures.is_empty()).collect();
    let mut files = Vec::new();
    for column in columns {
        if let Some(figure) = figure(column, columns, &solved) {
            let path = place.0.join(format!("{}.svg", file_name(column)));
            write(&figure, &path)?;
            files.push(path);
        }
    }
    Ok(files)
}

fn file_name(column: &str) -> String {
    let fine = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
    column
        .chars()
        .map(|c| if fine(c) { c } else { '_' })
        .collect()
}

/// What is drawn over `column`; nothing where its values are the same or no numbers.
fn figure(column: &str, columns: &[String], solved: &[&Record]) -> Option<Figure> {
    let system = solved
        .first()
        .and_then(|r| units(r))
        .unwrap_or(UnitSystem::MNPa);
    let values: Vec<&Value> = solved.iter().filter_map(|r| parameter(r, column)).collect();
    let (numbers, unit) = numbers(&values, system)?;
    if values.len() != solved.len() || numbers.windows(2).all(|pair| pair[0] == pair[1]) {
        return None;
    }
    let others = |record: &Record| -> String {
        let others = columns.iter().filter(|c| *c != column && varies(c, solved));
        let word = |c: &String| {
            format!(
                "{} {}",
                short(c),
                parameter(record, c).map_or("-".into(), said)
            )
        };
        others.map(word).collect::<Vec<_>>().join(", ")
    };
    let mut groups: Vec<String> = Vec::new();
    let group_of: Vec<usize> = (solved.iter())
        .map(|record| {
            let name = others(record);
            groups.iter().position(|g| *g == name).unwrap_or_else(|| {
                groups.push(name);
                groups.len() - 1
            })
        })
        .collect();
    // Parameters that vary together, as in a list, make one line.
    let together = groups.len() == solved.len();
    let many = !together && groups.len() > MOST;
    let panel = |(name, title, dashed): &(&str, &str, Option<f64>)| {
        let mut lines: Vec<Line> = Vec::new();
        for ((record, x), group) in solved.iter().zip(&numbers).zip(&group_of) {
            let Some(y) = record.number(name) else {
                continue;
            };
            let style = if together || many { 0 } else { *group };
            match lines
                .iter_mut()
                .find(|line| line.style == style)
                .filter(|_| !many)
            {
                Some(line) => line.points.push((*x, y)),
                None => lines.push(Line {
                    style,
                    points: vec![(*x, y)],
                }),
            }
        }
        for line in &mut lines {
            line.points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        Panel {
            title: title.to_string(),
            axes: [axis(column, &unit), String::new()],
            scale: Scale::Linear,
            dashed: dashed.filter(|_| !lines.is_empty()).into_iter().collect(),
            lines,
        }
    };
    let mut panels: Vec<Panel> = DRAWN.iter().map(panel).collect();
    panels.retain(|panel| !panel.lines.is_empty());
    let legend = match (together, many) {
        (true, _) => vec!["rows of the sweep".to_owned()],
        (_, true) => vec![format!("rows of the sweep, of {} kinds", groups.len())],
        _ if groups.len() == 1 => vec![String::from("rows of the sweep")],
        _ => groups,
    };
    (!panels.is_empty()).then(|| Figure {
        panels,
        legend,
        dashed: "the limit of (2-49): what lacks to it is the margin".to_owned(),
    })
}

fn axis(column: &str, unit: &str) -> String {
    match unit.is_empty() {
        true => column.to_owned(),
        false => format!("{column}, {unit}"),
    }
}

/// The last part of a dotted key.
fn short(column: &str) -> String {
    column
        .rsplit('.')
        .next()
        .unwrap_or(column)
        .replace('_', " ")
}

fn said(value: &Value) -> String {
    value
        .as_str()
        .map_or_else(|| value.to_string(), str::to_owned)
}

fn parameter<'r>(record: &'r Record, column: &str) -> Option<&'r Value> {
    let found = record.parameters.iter().find(|(key, _)| key == column);
    found.map(|(_, value)| value)
}

fn varies(column: &str, solved: &[&Record]) -> bool {
    let mut values = solved.iter().map(|record| parameter(record, column));
    let first = values.next();
    values.any(|value| Some(value) != first)
}

/// The units of a row's answer.
fn units(record: &Record) -> Option<UnitSystem> {
    let found = record.figures.iter().find(|(name, _)| name == "units");
    UnitSystem::from_name(found?.1.as_str()?)
}

/// The values as numbers in `system` with their unit; `None` where one is no number, or they measure
/// different things.
fn numbers(values: &[&Value], system: UnitSystem) -> Option<(Vec<f64>, String)> {
    let quantity = |v: &&Value| Some(Quantity::parse(v.as_str()?).ok()?.dimension());
    let dimension = values.iter().find_map(quantity).unwrap_or(Dimension::RATIO);
    let number = |value: &&Value| match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => {
            let number = Quantity::parse(text)
                .ok()?
                .value_in(system, dimension)
                .ok()?;
            Some(if dimension == Dimension::ANGLE {
                number.to_degrees()
            } else {
                number
            })
        }
        _ => None,
    };
    let numbers = values.iter().map(number).collect::<Option<Vec<f64>>>()?;
    (!numbers.is_empty()).then(|| (numbers, system.unit(dimension)))
}
