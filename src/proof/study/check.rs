//! Whether the page of the study still says what a fresh run says.

use super::page::PagePart;
use crate::render::page::{PageError, between};
use std::path::Path;

/// Largest relative difference of a figure of the page and of a fresh run: about a unit of the last of the four digits
/// that are printed.
const PRINTED_DIFFERENCE: f64 = 2e-3;

/// The same of what follows ±, an estimate that is printed to two digits.
const PRINTED_ESTIMATE_DIFFERENCE: f64 = 0.1;

/// A cell of the page that a fresh run does not confirm.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    pub part: &'static str,
    /// The first cell of the row.
    pub row: String,
    pub page: String,
    pub fresh: String,
}

/// Where the page does not say what a fresh run says, times apart.
///
/// # Errors
/// Where the page cannot be read or has no such part.
pub fn check(page: &Path, parts: &[PagePart]) -> Result<Vec<Difference>, PageError> {
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
            let share = if error {
                PRINTED_ESTIMATE_DIFFERENCE
            } else {
                PRINTED_DIFFERENCE
            };
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
