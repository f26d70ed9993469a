//! Numbers, words and lists as decks take them.

use std::io::{self, Write};

/// A number in at most 19 characters: CalculiX reads 20.
pub fn number(value: f64) -> String {
    format!("{value:.12e}")
}

/// `text` without line breaks, so that it stays one line of the deck and no keyword.
pub fn one_line(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    text.trim_start_matches([' ', '*']).to_string()
}

/// Writes `items` after each other, twelve to a line.
pub fn list(out: &mut dyn Write, items: impl IntoIterator<Item = usize>) -> io::Result<()> {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    for line in items.chunks(12) {
        writeln!(out, "{},", line.join(","))?;
    }
    Ok(())
}
