//! Tables in Markdown.

/// Headings and rows, every line ended. A bar within a cell is escaped.
pub fn table<S: AsRef<str>, R: AsRef<str>>(
    headings: impl IntoIterator<Item = S>,
    rows: impl IntoIterator<Item = impl IntoIterator<Item = R>>,
) -> String {
    let headings: Vec<String> = headings.into_iter().map(cell).collect();
    let rule = "|---".repeat(headings.len());
    let mut text = format!("{}{rule}|\n", line(headings));
    for row in rows {
        text.push_str(&line(row.into_iter().map(cell)));
    }
    text
}

fn cell(words: impl AsRef<str>) -> String {
    words.as_ref().replace('|', "\\|").replace('\n', " ")
}

fn line(cells: impl IntoIterator<Item = String>) -> String {
    let cells: Vec<String> = cells.into_iter().collect();
    format!("| {} |\n", cells.join(" | "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_stands_below_the_headings_and_bars_are_escaped() {
        let text = table(["", "mesh"], [["a|b", "h025"]]);
        assert_eq!(text, "|  | mesh |\n|---|---|\n| a\\|b | h025 |\n");
    }
}
