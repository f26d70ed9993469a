//! The line load along each contact line, q(y): `line-load.csv` and `line-load.svg`.

mod csv;
mod svg;

pub use csv::csv;
pub use svg::figure;

use super::plot;
use super::summary::Summary;
use crate::answer::LineFigures;
use crate::ground::file::write_text;
use crate::render::OutputError;
use std::path::Path;

/// Names of the files in the folder of a run.
pub const FILES: [&str; 2] = ["line-load.csv", "line-load.svg"];

/// A line of contact of the whole bearing, also where a part of it was modelled.
#[derive(Debug, Clone, PartialEq)]
pub struct WholeLine<'a> {
    pub interface: &'a str,
    /// The direction along which it runs.
    pub axis: &'a str,
    /// The direction across it.
    pub across_axis: &'a str,
    /// Its place across.
    pub across: f64,
    /// Coordinate along and force normal to the surface per length at each row of nodes; the
    /// integral by the trapezoidal rule is the force.
    pub rows: Vec<(f64, f64)>,
    /// The same force, spread evenly over the length of the carrier.
    pub mean: f64,
}

/// The lines of every interface, by their place across; images in mirror planes are written out.
pub fn whole_lines(summary: &Summary) -> Vec<WholeLine<'_>> {
    let mut all = Vec::new();
    for (interface, measured) in &summary.answer.interfaces.0 {
        let mut lines: Vec<WholeLine> = Vec::new();
        for line in &measured.lines {
            let across = [Some(line.across), (line.images > 1).then_some(-line.across)];
            lines.extend(across.into_iter().flatten().map(|across| WholeLine {
                interface,
                axis: &line.axis,
                across_axis: &line.across_axis,
                across,
                rows: whole_rows(line),
                mean: line.mean,
            }));
        }
        lines.sort_by(|a, b| a.across.total_cmp(&b.across));
        all.append(&mut lines);
    }
    all
}

/// The rows of the whole line: a row in the mirror plane is its own image.
fn whole_rows(line: &LineFigures) -> Vec<(f64, f64)> {
    let rows = || line.at.iter().copied().zip(line.load.iter().copied());
    let reach = line.at.iter().fold(0.0f64, |most, at| most.max(at.abs()));
    let images: Vec<(f64, f64)> = if line.mirrored {
        rows()
            .filter(|(at, _)| at.abs() > 1e-6 * reach)
            .map(|(at, load)| (-at, load))
            .collect()
    } else {
        Vec::new()
    };
    images.into_iter().rev().chain(rows()).collect()
}

/// Writes both files into `folder`; none where nothing presses along lines.
///
/// # Errors
/// [`OutputError`] with the path that could not be written.
pub fn write(summary: &Summary, folder: &Path) -> Result<(), OutputError> {
    let lines = whole_lines(summary);
    if lines.is_empty() {
        return Ok(());
    }
    let [data, picture] = FILES.map(|name| folder.join(name));
    write_text(&data, &csv(&lines, &summary.units))?;
    plot::write(&figure(&lines, &summary.units), &picture)
}
