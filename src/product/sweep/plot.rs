//! Peak Mises stress and utilisation over each parameter that varies and is a number.

use super::error::SweepError;
use super::parameter;
use super::place::SweepFolder;
use super::record::RowRecord;
use crate::ground::units::UnitSystem;
use crate::render::plot::{Line, Panel, PlotFigure, Scale, write};
use std::path::PathBuf;

/// Lines of more groups than this cannot be told apart: then there are dots only.
const MOST_GROUPS: usize = 7;

/// A figure that is drawn.
struct PlottedFigure {
    /// In the table.
    name: &'static str,
    title: &'static str,
    unit: fn(UnitSystem) -> &'static str,
    /// Dashed across.
    limit: Option<f64>,
}

const PEAK: &str = "mises_nodal";
const ELASTIC: &str = "elastic_mises_nodal";

const PLOTTED_FIGURES: [PlottedFigure; 4] = [
    PlottedFigure {
        name: PEAK,
        title: "largest Mises, nodal",
        unit: UnitSystem::stress,
        limit: None,
    },
    PlottedFigure {
        name: ELASTIC,
        title: "largest Mises, nodal, without yielding",
        unit: UnitSystem::stress,
        limit: None,
    },
    PlottedFigure {
        name: "utilisation",
        title: "p0 under the largest line load, over 1.65 yield",
        unit: |_| "",
        limit: Some(1.0),
    },
    PlottedFigure {
        name: "descent",
        title: "descent",
        unit: UnitSystem::length,
        limit: None,
    },
];

/// Draws what the rows came to over each parameter; comes back with the files.
///
/// # Errors
/// [`SweepError::Output`] names the path.
pub fn draw(
    place: &SweepFolder,
    columns: &[String],
    records: &[RowRecord],
) -> Result<Vec<PathBuf>, SweepError> {
    let solved: Vec<&RowRecord> = records.iter().filter(|r| !r.figures.is_empty()).collect();
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
    let letters = column.chars();
    letters.map(|c| if fine(c) { c } else { '_' }).collect()
}

/// What is drawn over `column`; nothing where its values are the same or no numbers.
fn figure(column: &str, columns: &[String], solved: &[&RowRecord]) -> Option<PlotFigure> {
    let (at, unit) = parameter::numbers(column, solved)?;
    if at.windows(2).all(|pair| pair[0] == pair[1]) {
        return None;
    }
    let groups = RowGroups::of(column, columns, solved);
    let system = parameter::units(solved.first()?)?;
    let yielded = solved.iter().any(|r| r.number(PEAK) != r.number(ELASTIC));
    let shown = |drawn: &&PlottedFigure| drawn.name != ELASTIC || yielded;
    let panel = |drawn: &PlottedFigure| Panel {
        title: with_unit(drawn.title, (drawn.unit)(system)),
        axes: [with_unit(column, &unit), String::new()],
        scale: Scale::Linear,
        lines: groups.lines(&at, solved, drawn.name),
        dashed: drawn.limit.into_iter().collect(),
    };
    let mut panels: Vec<Panel> = PLOTTED_FIGURES.iter().filter(shown).map(panel).collect();
    panels.retain(|panel| !panel.lines.is_empty());
    (!panels.is_empty()).then(|| PlotFigure {
        panels,
        legend: groups.names,
        dashed: "the limit of (2-49): what lacks to it is the margin".to_owned(),
    })
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {unit}")
    }
}

/// Rows that differ in one parameter only, joined by lines.
struct RowGroups {
    names: Vec<String>,
    /// Of each row.
    of: Vec<usize>,
    joined: bool,
}

impl RowGroups {
    fn of(column: &str, columns: &[String], solved: &[&RowRecord]) -> Self {
        let others = columns.iter().filter(|c| *c != column);
        let others: Vec<&String> = others.filter(|c| parameter::varies(c, solved)).collect();
        let mut names: Vec<String> = Vec::new();
        let group = |record: &&RowRecord| {
            let words = others.iter().map(|c| parameter::said(record, c));
            let name = words.collect::<Vec<_>>().join(", ");
            names.iter().position(|n| *n == name).unwrap_or_else(|| {
                names.push(name);
                names.len() - 1
            })
        };
        let of: Vec<usize> = solved.iter().map(group).collect();
        // Parameters that vary together, as they may in a list, make one line.
        let together = names.len() == solved.len() || names.len() == 1;
        if together || names.len() > MOST_GROUPS {
            return Self {
                names: vec!["rows of the sweep".to_owned()],
                of: vec![0; solved.len()],
                joined: together,
            };
        }
        Self {
            names,
            of,
            joined: true,
        }
    }

    /// The lines of the figure `name` over the numbers `at`.
    fn lines(&self, at: &[f64], solved: &[&RowRecord], name: &str) -> Vec<Line> {
        let mut lines: Vec<Line> = Vec::new();
        for ((record, x), style) in solved.iter().zip(at).zip(&self.of) {
            let Some(y) = record.number(name) else {
                continue;
            };
            let same = |line: &&mut Line| self.joined && line.style == *style;
            match lines.iter_mut().find(same) {
                Some(line) => line.points.push((*x, y)),
                None => lines.push(Line::dotted(*style, vec![(*x, y)])),
            }
        }
        for line in &mut lines {
            line.points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::super::record::RowStatus;
    use super::*;
    use serde_json::json;

    /// A solved row with a wall, a load and a peak.
    fn record(wall: &str, load: &str, peak: f64) -> RowRecord {
        let named = |pairs: &[(&str, serde_json::Value)]| {
            let own = pairs.iter().map(|(k, v)| ((*k).to_owned(), v.clone()));
            own.collect()
        };
        RowRecord {
            row: 1,
            folder: String::new(),
            fingerprint: String::new(),
            parameters: named(&[("b.wall", json!(wall)), ("b.load", json!(load))]),
            status: RowStatus::Done,
            message: String::new(),
            seconds: 1.0,
            figures: named(&[
                ("units", json!("in-kip-ksi")),
                (PEAK, json!(peak)),
                (ELASTIC, json!(peak)),
            ]),
        }
    }

    fn columns() -> Vec<String> {
        vec!["b.wall".to_owned(), "b.load".to_owned()]
    }

    #[test]
    fn a_line_for_each_group_in_the_units_of_the_case() {
        let rows = [
            record("25.4 mm", "45 kip", 30.0),
            record("0.5 in", "45 kip", 40.0),
            record("0.5 in", "65 kip", 60.0),
            record("1 in", "65 kip", 50.0),
        ];
        let rows: Vec<&RowRecord> = rows.iter().collect();
        let figure = figure("b.wall", &columns(), &rows).unwrap();
        assert_eq!(figure.legend, ["load 45 kip", "load 65 kip"]);
        // Nothing has yielded, and there is neither utilisation nor descent.
        let [panel] = figure.panels.as_slice() else {
            panic!("{:?}", figure.panels)
        };
        assert_eq!(panel.axes[0], "b.wall, in");
        assert_eq!(panel.title, "largest Mises, nodal, ksi");
        for (line, peaks) in panel.lines.iter().zip([[40.0, 30.0], [60.0, 50.0]]) {
            assert_eq!(line.points.len(), 2);
            for (point, expected) in line.points.iter().zip([0.5, 1.0].into_iter().zip(peaks)) {
                // 25.4 mm are an inch but for rounding.
                assert!((point.0 - expected.0).abs() < 1e-12, "{point:?}");
                assert_eq!(point.1, expected.1);
            }
        }
    }

    #[test]
    fn what_varies_together_is_one_line_and_words_are_none() {
        let rows = [
            record("thin", "45 kip", 30.0),
            record("thick", "65 kip", 40.0),
        ];
        let rows: Vec<&RowRecord> = rows.iter().collect();
        let over_load = figure("b.load", &columns(), &rows).unwrap();
        assert_eq!(over_load.panels[0].lines.len(), 1);
        assert_eq!(over_load.panels[0].lines[0].points.len(), 2);
        assert!(figure("b.wall", &columns(), &rows).is_none());
    }
}
