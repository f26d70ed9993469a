//! The generated parts of the page of the study.

use super::cells::{DIGITS, cell};
use super::compare;
use super::member::SolvedMember;
use super::quantities::ROWS;
use crate::ground::file::{FileError, write_atomically};
use crate::ground::markdown::table;
use crate::product::target::{Level, RefinedFigure};
use crate::render::Summary;
use crate::render::page::{PageError, insert};
use crate::render::text::significant;
use std::path::Path;

/// The page, from the folder where the command is run.
pub const PAGE: &str = "docs/section-2.6.2.md";

/// Cases whose line loads the page shows, and the file that has them.
const PICTURED: [&str; 2] = ["initial-centre", "initial-offset-2.5"];
const LINE_LOAD: &str = "line-load.svg";

/// A generated part of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct PagePart {
    /// Of its markers.
    pub name: &'static str,
    pub text: String,
    /// Holds times, which differ from run to run.
    pub timed: bool,
}

/// The parts that the solved cases fill.
pub fn parts(solved: &[SolvedMember]) -> Vec<PagePart> {
    let part = |name, text: String, timed| PagePart { name, text, timed };
    let mut parts = Vec::new();
    if solved.iter().all(|case| case.report_like.is_some()) {
        let table = cases(solved, |case| case.report_like.as_ref());
        parts.push(part("report-like", table, false));
    }
    if solved.iter().all(|case| !case.resolved.is_empty()) {
        parts.push(part("resolved", cases(solved, SolvedMember::finest), false));
        parts.push(part("series", series(solved), false));
        parts.push(part("cost", cost(solved), true));
        if parts.iter().any(|p| p.name == "report-like") {
            parts.push(part("compared", compare::table(solved), false));
        }
    }
    parts
}

/// One column a case.
fn cases<'s>(
    solved: &'s [SolvedMember],
    of: impl Fn(&'s SolvedMember) -> Option<&'s Summary>,
) -> String {
    quantities(solved.iter().map(|case| (case.name.to_owned(), of(case))))
}

/// Every resolved mesh of every case.
fn series(solved: &[SolvedMember]) -> String {
    let mut text = String::new();
    for case in solved {
        let meshes = case.resolved.iter();
        let columns = meshes.map(|level| (name(level), Some(&level.summary)));
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
    let headings = std::iter::once("").chain(names.iter().map(String::as_str));
    let rows = ROWS.iter().filter_map(|quantity| {
        let readings = runs.iter().map(|run| run.and_then(quantity.read));
        let cells: Vec<String> = readings.map(cell).collect();
        let is_known = cells.iter().any(|c| c != "-");
        is_known.then(|| std::iter::once(quantity.name.to_owned()).chain(cells))
    });
    table(headings, rows)
}

/// Of a level, in a heading.
fn name(level: &Level) -> String {
    let twin = if level.twin { ", elastic" } else { "" };
    format!("{} unknowns{twin}", level.unknowns)
}

/// Error against run time: what each mesh took, and the figure asked for that it knows worst.
fn cost(solved: &[SolvedMember]) -> String {
    let headings = [
        "case",
        "mesh",
        "known worst",
        "value",
        "± estimate",
        "wall, s",
        "CPU, s",
        "memory, MB",
    ];
    let mut rows: Vec<[String; 8]> = Vec::new();
    let seconds = |s: f64| significant(s, 3);
    for case in solved {
        for level in &case.resolved {
            let relative =
                |f: &RefinedFigure| f.estimate.map_or(f64::INFINITY, |e| e / f.value.abs());
            let figures = level.figures.iter();
            let worst = figures.max_by(|a, b| relative(a).total_cmp(&relative(b)));
            let [what, value, estimate] = worst.map_or_else(Default::default, |figure| {
                [
                    figure.what.name().to_owned(),
                    significant(figure.value, DIGITS),
                    figure.estimate_in_words(),
                ]
            });
            let memory = level.cost.peak_memory_bytes;
            rows.push([
                case.name.to_owned(),
                name(level),
                what,
                value,
                estimate,
                seconds(level.cost.wall_s),
                seconds(level.cost.cpu_s),
                memory.map_or_else(|| "-".into(), |b| format!("{:.0}", b as f64 / 1e6)),
            ]);
        }
        let sum = |of: fn(&Level) -> f64| seconds(case.resolved.iter().map(of).sum());
        rows.push([
            format!("**{}**", case.name),
            "all".to_owned(),
            if case.missed.is_none() {
                "target met".to_owned()
            } else {
                "target not met".to_owned()
            },
            String::new(),
            String::new(),
            sum(|level| level.cost.wall_s),
            sum(|level| level.cost.cpu_s),
            String::new(),
        ]);
    }
    table(headings, rows)
}

/// Writes the parts into the page.
///
/// # Errors
/// Where the page cannot be read or written.
pub fn write(page: &Path, parts: &[PagePart]) -> Result<(), PageError> {
    parts
        .iter()
        .try_for_each(|part| insert(page, part.name, &part.text))
}

/// Copies the line loads of the finest meshes, from below `out`, to where the page looks for them.
///
/// # Errors
/// Where a picture cannot be written.
pub fn write_pictures(page: &Path, solved: &[SolvedMember], out: &Path) -> Result<(), PageError> {
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
