//! Tables in the Markdown pages that the program writes.

use super::text::{cell, heading};
use super::{Heading, Table};

/// Headings and rows; the title and what else is said stands in the text of the page.
pub fn markdown(table: &Table) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let headings: Vec<String> = table.headings.iter().map(heading).collect();
    let rule = |_: &Heading| "---".to_string();
    let rule: Vec<String> = table.headings.iter().map(rule).collect();
    let mut text = format!("{}|{}|\n", line(headings), rule.join("|"));
    for row in &table.rows {
        text.push_str(&line(row.iter().map(cell).collect()));
    }
    text
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
