//! The generated parts of the page of the study.

use super::Solved;
use super::quantities::{ROWS, Reading};
use crate::ground::file::{FileError, write_atomically};
use crate::render::Summary;
use crate::render::page::{PageError, between, insert};
use crate::render::summary::{Comparison, Reported};
use crate::render::text::significant;
use std::path::Path;

/// The page, from the folder where the command is run.
pub const PAGE: &str = "docs/section-2.6.2.md";

/// Cases whose line loads the page shows, and the file that has them.
const PICTURED: [&str; 2] = ["initial-centre", "initial-offset-2.5"];
const LINE_LOAD: &str = "line-load.svg";

const DIGITS: usize = 4;
/// Figures of the page and of a fresh run may differ by this share: less than a unit of the last
/// digit that is printed.
const SAME: f64 = 2e-3;

/// A generated part of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Of its markers.
    pub name: &'static str,
    pub text: String,
    /// Holds times, which differ from run to run.
    pub timed: bool,
}

/// A cell of the page that a fresh run does not confirm.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    pub part: &'static str,
    /// The first cell of the row.
    pub row: String,
    pub page: String,
    pub fresh: String,
}

/// The parts that the solved cases fill.
pub fn parts(solved: &[Solved]) -> Vec<Part> {
    let part = |name, text: String, timed| Part { name, text, timed };
    let mut parts = Vec::new();
    if solved.iter().all(|case| case.report_like.is_some()) {
        let table = cases(solved, |case| case.report_like.as_ref());
        parts.push(part("report-like", table, false));
    }
    if solved.iter().all(|case| !case.resolved.is_empty()) {
        parts.push(part("resolved", cases(solved, Solved::finest), false));
        parts.push(part("series", series(solved), false));
        parts.push(part("cost", cost(solved), true));
        if parts.iter().any(|p| p.name == "report-like") {
            parts.push(part("compared", super::compare::table(solved), false));
        }
    }
    parts
}

/// One column a case.
fn cases<'s>(solved: &'s [Solved], of: impl Fn(&'s Solved) -> Option<&'s Summary>) -> String {
    quantities(solved.iter().map(|case| (case.name.to_owned(), of(case))))
}

/// Every resolved mesh of every case.
fn series(solved: &[Solved]) -> String {
    let mut text = String::new();
    for case in solved {
        let meshes = case.resolved.iter();
        let columns = meshes.map(|l| (format!("{} unknowns", l.unknowns), Some(&l.summary)));
        let verdict = match &case.missed {
            None => "The target is met.".to_owned(),
            Some(why) => format!("The target: {why}."),
        };
        let table = quantities(columns);
        text.push_str(&format!("**{}**\n\n{table}\n{verdict}\n\n", case.name));
    }
    text
}

/// One line a quantity, one column a run, under its heading.
fn quantities<'s>(columns: impl Iterator<Item = (String, Option<&'s Summary>)>) -> String {
    let (names, runs): (Vec<String>, Vec<Option<&Summary>>) = columns.unzip();
    let mut text = head(std::iter::once("").chain(names.iter().map(String::as_str)));
    for quantity in &ROWS {
        let readings = runs.iter().map(|run| run.and_then(quantity.read));
        let cells: Vec<String> = readings.map(cell).collect();
        if cells.iter().any(|c| c != "-") {
            text.push_str(&format!("| {} | {} |\n", quantity.name, cells.join(" | ")));
        }
    }
    text
}

/// Error against run time.
fn cost(solved: &[Solved]) -> String {
    let headings = [
        "case",
        "unknowns",
        "figure",
        "value",
        "± estimate",
        "change",
        "wall, s",
        "CPU, s",
        "memory, MB",
    ];
    let mut text = head(headings);
    for case in solved {
        for level in &case.resolved {
            for figure in &level.figures {
                let memory = level.cost.peak_memory_bytes;
                text.push_str(&format!(
                    "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                    case.name,
                    level.unknowns,
                    figure.what.name(),
                    significant(figure.value, DIGITS),
                    figure.share(figure.estimate),
                    figure.share(figure.change),
                    significant(level.cost.wall_s, 3),
                    significant(level.cost.cpu_s, 3),
                    memory.map_or_else(|| "-".into(), |b| format!("{:.0}", b as f64 / 1e6)),
                ));
            }
        }
    }
    text
}

/// Heading and rule of a table.
pub(super) fn head<'a>(cells: impl IntoIterator<Item = &'a str>) -> String {
    let cells: Vec<&str> = cells.into_iter().collect();
    let rule = "|---".repeat(cells.len());
    format!("| {} |\n{rule}|\n", cells.join(" | "))
}

/// A figure with its error.
pub(super) fn cell(reading: Option<Reading>) -> String {
    match reading {
        None => "-".to_owned(),
        Some(Reading { value, error: None }) => significant(value, DIGITS),
        Some(Reading {
            value,
            error: Some(error),
        }) => format!("{} ± {}", significant(value, DIGITS), significant(error, 2)),
    }
}

/// What the study prints of a quantity.
pub(super) fn printed(row: &Comparison) -> Option<f64> {
    match row.report {
        Some(Reported::Value(value)) => Some(value),
        _ => None,
    }
}

/// Writes the parts into the page.
///
/// # Errors
/// Where the page cannot be read or written.
pub fn write(page: &Path, parts: &[Part]) -> Result<(), PageError> {
    parts
        .iter()
        .try_for_each(|part| insert(page, part.name, &part.text))
}

/// Copies the line loads of the finest meshes, from below `out`, to where the page looks for them.
///
/// # Errors
/// Where a picture cannot be written.
pub fn write_pictures(page: &Path, solved: &[Solved], out: &Path) -> Result<(), PageError> {
    let images = page.with_file_name("images");
    let shown = solved.iter().filter(|case| PICTURED.contains(&case.name));
    for case in shown.filter(|case| !case.resolved.is_empty()) {
        let from = case.folder(out).join(LINE_LOAD);
        let picture = std::fs::read(&from);
        let picture = picture.map_err(|source| FileError::Read { path: from, source })?;
        let to = images.join(format!("section-2.6.2-{}.svg", case.name));
        write_atomically(&to, |file| file.write_all(&picture))?;
    }
    Ok(())
}

/// Where the page does not say what a fresh run says, times apart.
///
/// # Errors
/// Where the page cannot be read or has no such part.
pub fn check(page: &Path, parts: &[Part]) -> Result<Vec<Difference>, PageError> {
    let mut differences = Vec::new();
    for part in parts.iter().filter(|part| !part.timed) {
        let old = between(page, part.name)?;
        let (old, new): (Vec<&str>, Vec<&str>) = (
            old.trim().lines().collect(),
            part.text.trim().lines().collect(),
        );
        for i in 0..old.len().max(new.len()) {
            let [page, fresh] = [&old, &new].map(|lines| lines.get(i).copied().unwrap_or(""));
            if !alike(page, fresh) {
                let row = fresh.split('|').nth(1).unwrap_or("").trim();
                differences.push(Difference {
                    part: part.name,
                    row: row.to_owned(),
                    page: page.to_owned(),
                    fresh: fresh.to_owned(),
                });
            }
        }
    }
    Ok(differences)
}

/// Do two lines say the same, word by word, numbers to the digits that are printed?
fn alike(page: &str, fresh: &str) -> bool {
    let (a, b): (Vec<&str>, Vec<&str>) = (
        page.split_whitespace().collect(),
        fresh.split_whitespace().collect(),
    );
    let mut error = false;
    a.len() == b.len()
        && a.iter().zip(&b).all(|(a, b)| {
            // What follows ± is an estimate, printed to two digits.
            let share = if error { 0.1 } else { SAME };
            error = *a == "±";
            match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(x), Ok(y)) => (x - y).abs() <= share * x.abs().max(y.abs()),
                _ => a == b,
            }
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_alike_to_the_digits_they_print() {
        assert!(alike(
            "| p0 | 182.3 ± 1.2 | - |",
            "| p0 | 182.4 ± 1.3 | - |"
        ));
        assert!(!alike("| p0 | 182.3 |", "| p0 | 184.3 |"));
        assert!(!alike("| p0 | 182.3 |", "| p0 | - |"));
        assert!(!alike("| p0 | 182.3 |", ""));
    }
}
