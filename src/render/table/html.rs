//! Tables on a page.

use super::{Cell, Heading, Number, Table};
use crate::render::figures::{DASH, MESH_DIGITS, NOT_RESOLVED, off, share, with_error};
use crate::render::text::{place, significant};
use maud::{Markup, html};

/// The tables below one another; nothing of those without rows.
pub fn tables(tables: &[Table]) -> Markup {
    html! { @for each in tables { (table(each)) } }
}

/// The table, its notes and what it is about; nothing where it has no rows.
pub fn table(table: &Table) -> Markup {
    let words = |k: usize| table.headings.get(k).is_some_and(|h| k > 0 && h.words);
    let class = |k: usize| words(k).then_some("left");
    let caption = &table.title;
    html! {
        @if !table.rows.is_empty() {
            div class="scroll" {
                table {
                    @if !caption.is_empty() { caption { (caption) } }
                    thead {
                        tr {
                            @for (k, head) in table.headings.iter().enumerate() {
                                th scope="col" class=[class(k)] { (heading(head)) }
                            }
                        }
                    }
                    tbody {
                        @for row in &table.rows {
                            tr {
                                @for (k, place) in row.iter().enumerate() {
                                    @if k == 0 {
                                        th scope="row" { (cell(place)) }
                                    } @else {
                                        td class=[class(k)] { (cell(place)) }
                                    }
                                }
                            }
                        }
                    }
                }
            }
            @for note in &table.notes { p class="note" { (note) } }
            @if !table.about.is_empty() { p class="note" { (table.about) } }
        }
    }
}

fn heading(heading: &Heading) -> String {
    match (heading.name.as_str(), heading.unit.as_str()) {
        (name, "") => name.to_string(),
        ("", unit) => unit.to_string(),
        (name, unit) => format!("{name}, {unit}"),
    }
}

fn cell(cell: &Cell) -> Markup {
    match cell {
        Cell::Text(words) => html! { (words) },
        Cell::Care(words) => html! { b class="care" { (words) } },
        Cell::Figure(number) | Cell::Estimate(number) => figure(number),
        Cell::Tiny(value) => html! { (format!("{value:.1e}")) },
        Cell::Share(part) => html! { (share(part.filter(|s| s.is_finite()))) },
        Cell::Off(part) => html! { (part.map_or_else(|| DASH.to_string(), off)) },
        Cell::Count(count) => html! { (count) },
        Cell::Met(Some(true)) => html! { b class="good" { "yes" } },
        Cell::Met(Some(false)) => html! { b class="bad" { "NO" } },
        Cell::Met(None) => html! { (DASH) },
        Cell::Place(at) => html! { (at.map_or_else(|| DASH.to_string(), place)) },
    }
}

/// With as many digits as the error leaves; without those that the mesh does not resolve.
fn figure(number: &Number) -> Markup {
    let Some(value) = number.value else {
        return html! { (DASH) };
    };
    let digits = match (number.error, number.at_edge || !number.resolved) {
        (Some(_), _) if number.resolved => with_error(value, number.error),
        (_, true) => significant(value, MESH_DIGITS),
        (_, false) => significant(value, number.digits),
    };
    html! {
        (digits)
        @if number.at_edge { "*" }
        @if !number.resolved { ", " b class="care" { (NOT_RESOLVED) } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_escaped_and_figures_marked() {
        let mut table = Table::new("Peaks").words("body").figure("Mises", "ksi");
        let number = Number {
            at_edge: true,
            ..Number::new(93.12, 4)
        };
        table.row(["a<b>".into(), Cell::Figure(number)]);
        table.row(["c".into(), Cell::Met(Some(false))]);
        let text = self::table(&table).into_string();
        for part in ["a&lt;b&gt;", "Mises, ksi", "<td>93*</td>", "NO</b>"] {
            assert!(text.contains(part), "{part} in {text}");
        }
        table.rows.clear();
        assert!(self::table(&table).0.is_empty());
    }
}
