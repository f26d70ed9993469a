//! Tables in the Markdown pages that the program writes.

use super::Table;
use super::text::{cell, heading};
use crate::ground::markdown;

/// Headings and rows; the title and what else is said stands in the text of the page.
pub fn markdown(table: &Table) -> String {
    let rows = table.rows.iter().map(|row| row.iter().map(cell));
    markdown::table(table.headings.iter().map(heading), rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::table::Cell;

    #[test]
    fn a_rule_stands_below_the_headings() {
        let mut table = Table::new("").words("body").figure("Mises", "ksi");
        table.row(["roller".into(), Cell::figure(93.12)]);
        let expected = "| body | Mises ksi |\n|---|---|\n| roller | 93.12 |\n";
        assert_eq!(markdown(&table), expected);
    }
}
