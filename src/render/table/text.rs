//! Tables on the terminal.

use super::{Cell, Heading, Number, Table};
use crate::render::figures::{MESH_DIGITS, off};
use crate::render::text::{percent, place, significant};
use std::fmt::Write;

/// In place of a figure that there is not.
const DASH: &str = "-";

/// The table, every line ended; nothing where it has no rows. A table without a title begins with its first heading
/// at the margin, else everything below the title is indented by two.
pub fn text(table: &Table) -> String {
    if table.rows.is_empty() {
        return String::new();
    }
    let shown = |k: usize| !table.headings.get(k).is_some_and(|h| h.wide);
    let headings: Vec<String> = (table.headings.iter().filter(|h| !h.wide))
        .map(heading)
        .collect();
    let words: Vec<bool> = (table.headings.iter().filter(|h| !h.wide))
        .map(|h| h.words)
        .collect();
    let mut lines = vec![headings];
    lines.extend(table.rows.iter().map(|row| -> Vec<String> {
        let cells = row.iter().enumerate().filter(|(k, _)| shown(*k));
        cells.map(|(_, cell)| self::cell(cell)).collect()
    }));
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| {
        let cells = lines.iter().filter_map(|line| line.get(c));
        cells.map(|s| s.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    if !table.title.is_empty() {
        text = format!("{}\n", table.title);
    }
    for (k, cells) in lines.iter().enumerate() {
        let at_margin = k == 0 && table.title.is_empty();
        let mut line = String::from(if at_margin { "" } else { "  " });
        for (c, cell) in cells.iter().enumerate() {
            let width = widths[c];
            // Writing to a string cannot fail.
            let _ = match c {
                0 if at_margin => write!(line, "{cell:<0$}", width + 2),
                0 => write!(line, "{cell:<width$}"),
                _ if words.get(c) == Some(&true) => write!(line, "  {cell:<width$}"),
                _ => write!(line, "  {cell:>width$}"),
            };
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    for note in &table.notes {
        let _ = writeln!(text, "  {note}");
    }
    text
}

/// Tables with a blank line between them.
pub fn texts(tables: &[Table]) -> String {
    let texts: Vec<String> = tables.iter().map(text).filter(|t| !t.is_empty()).collect();
    texts.join("\n")
}

pub(super) fn heading(heading: &Heading) -> String {
    format!("{} {}", heading.name, heading.unit)
        .trim()
        .to_string()
}

pub(super) fn cell(cell: &Cell) -> String {
    let dash = || DASH.to_string();
    match cell {
        Cell::Text(words) | Cell::Care(words) => words.clone(),
        Cell::Figure(number) => figure(number),
        Cell::Estimate(number) => estimate(number),
        Cell::Tiny(value) => format!("{value:.1e}"),
        Cell::Share(share) => share.filter(|s| s.is_finite()).map_or_else(dash, percent),
        Cell::Off(share) => share.map_or_else(dash, off),
        Cell::Count(count) => count.to_string(),
        Cell::Met(met) => met
            .map_or(DASH, |met| if met { "yes" } else { "NO" })
            .into(),
        Cell::Place(at) => at.map_or_else(dash, place),
    }
}

fn figure(number: &Number) -> String {
    match number.value {
        None => DASH.to_string(),
        Some(value) if number.at_edge => significant(value, MESH_DIGITS) + "*",
        Some(value) => significant(value, number.digits),
    }
}

fn estimate(number: &Number) -> String {
    match (number.value, number.error) {
        (Some(value), _) if !number.resolved => {
            format!("{}, unresolved", significant(value, MESH_DIGITS))
        }
        (Some(_), Some(error)) => format!("{} ± {}", figure(number), significant(error, 2)),
        _ => figure(number),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up_by_characters_and_wide_ones_are_left_out() {
        let mut table = Table::new("Volumes")
            .words("body")
            .figures(["at"])
            .wide()
            .figure("", "in³");
        assert_eq!(text(&table), "");
        table.row(["roller".into(), Cell::Place(None), Cell::rough(1.5)]);
        table.note("as meshed");
        assert_eq!(
            text(&table),
            "Volumes\n  body     in³\n  roller  1.50\n  as meshed\n"
        );
        table.title.clear();
        assert!(text(&table).starts_with("body       in³\n"));
    }

    #[test]
    fn figures_say_what_they_are_worth() {
        let number = Number {
            error: Some(1.23),
            ..Number::new(93.12, 4)
        };
        assert_eq!(cell(&Cell::Figure(number)), "93.12");
        assert_eq!(cell(&Cell::Estimate(number)), "93.12 ± 1.2");
        let unresolved = Number {
            resolved: false,
            ..number
        };
        assert_eq!(cell(&Cell::Estimate(unresolved)), "93, unresolved");
        let at_edge = Number {
            at_edge: true,
            ..number
        };
        assert_eq!(cell(&Cell::Figure(at_edge)), "93*");
        assert_eq!(cell(&Cell::Share(Some(f64::NAN))), "-");
    }
}
