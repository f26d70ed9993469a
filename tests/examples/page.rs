//! The page of an example in the book: its excerpt is in the program, and its figures are what the program finds.

use std::path::Path;

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Checks the page of the example `name` against its source and its figures: what, computed, exact.
pub fn check(name: &str, figures: &[(&str, f64, f64)]) {
    let page = read(&format!("docs/book/library/{}.md", name.replace('_', "-")));
    let program = read(&format!("examples/{name}.rs"));
    let (_, rest) = page.split_once("```rust\n").expect("an excerpt");
    let (excerpt, _) = rest.split_once("```").expect("its end");
    for line in excerpt.lines() {
        assert!(
            program.contains(line.trim()),
            "{name}: `{line}` is not in it"
        );
    }
    for (what, value, exact) in figures {
        let line = page.lines().find(|line| line.starts_with(what));
        let line = line.unwrap_or_else(|| panic!("{name}: its page has no `{what}`"));
        let numbers: Vec<f64> = (line[what.len()..].split_whitespace())
            .filter_map(|word| word.parse().ok())
            .collect();
        // As printed; another machine may differ in the last digits.
        for (said, found) in numbers.iter().zip([value, exact]) {
            let off = (said - found).abs();
            assert!(
                off < 1e-3 * found.abs() + 1e-5,
                "{name}: {what}: {said} for {found}"
            );
        }
    }
}
